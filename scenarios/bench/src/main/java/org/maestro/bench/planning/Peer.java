package org.maestro.bench.planning;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;

/**
 * Another planner as a Python package brings it, if that is installed for the {@code python3} of
 * the path. It runs in a process of its own, with the options that its package gives for plans that
 * are proven to be the cheapest.
 */
final class Peer {
  private static final String PLAN_FILE = "plan.txt";
  private static final String WHERE =
      "import importlib.util as u, os; s = u.find_spec('%s');"
          + " print(os.path.join(os.path.dirname(s.origin), '%s'))";
  private static final double GRACE_SECONDS = 5;

  /** A planner: its name, and the place where its package keeps it. */
  enum Kind {
    FAST_DOWNWARD("Fast Downward", "up_fast_downward", "downward/fast-downward.py"),
    ENHSP("ENHSP", "up_enhsp", "ENHSP/enhsp.jar");

    private final String words;
    private final String module;
    private final String file;

    Kind(String words, String module, String file) {
      this.words = words;
      this.module = module;
      this.file = file;
    }

    /** Fast Downward has exit codes of its own for that, while making ground and in the search. */
    private boolean saysThatNoneExists(int exitValue) {
      return this == FAST_DOWNWARD && (exitValue == 10 || exitValue == 11);
    }

    private List<String> command(Path program, double deadlineSeconds) {
      return this == FAST_DOWNWARD
          ? List.of(
              "python3",
              program.toString(),
              "--overall-time-limit",
              (int) Math.ceil(deadlineSeconds) + "s",
              "--plan-file",
              PLAN_FILE,
              "domain.pddl",
              "problem.pddl",
              "--search",
              "astar(lmcut())")
          : List.of(
              "java",
              "-jar",
              program.toString(),
              "-o",
              "domain.pddl",
              "-f",
              "problem.pddl",
              "-sp",
              PLAN_FILE,
              "-s",
              "WAStar",
              "-h",
              "hrmax");
    }
  }

  private final Kind kind;
  private final double deadlineSeconds;
  private final Optional<Path> program;

  Peer(Kind kind, double deadlineSeconds) {
    this.kind = kind;
    this.deadlineSeconds = deadlineSeconds;
    this.program = find(kind);
  }

  /** All that are known here, whether they are installed or not. */
  static List<Peer> all(double deadlineSeconds) {
    return Stream.of(Kind.values()).map(kind -> new Peer(kind, deadlineSeconds)).toList();
  }

  private static Optional<Path> find(Kind kind) {
    try {
      Process python =
          new ProcessBuilder("python3", "-c", WHERE.formatted(kind.module, kind.file))
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      String path =
          new String(python.getInputStream().readAllBytes(), StandardCharsets.UTF_8).strip();
      return path.isEmpty() ? Optional.empty() : Optional.of(Path.of(path)).filter(Files::exists);
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  String name() {
    return kind.words;
  }

  boolean isInstalled() {
    return program.isPresent();
  }

  /** Whether its times stand beside ours, and if not, what to do. */
  String standing() {
    return isInstalled()
        ? "%s: installed, %.0f s for each problem, its start included"
            .formatted(name(), deadlineSeconds)
        : "%s: not installed for python3, so no times of it beside ours (pip install %s)"
            .formatted(name(), kind.module.replace('_', '-'));
  }

  /** The end of a planner's run: of its own accord with or without a plan, or at the deadline. */
  enum End {
    PLAN,
    /** It says that there is none. */
    NO_PLAN_EXISTS,
    GAVE_UP,
    STOPPED
  }

  /** The end of a planner's run on a problem, and the time until then. */
  record Outcome(End end, double passedMilliseconds) {
    /** Until it had its plan; empty when it has none. */
    OptionalDouble milliseconds() {
      return end == End.PLAN ? OptionalDouble.of(passedMilliseconds) : OptionalDouble.empty();
    }

    String text() {
      String words =
          switch (end) {
            case PLAN -> "%.0f ms";
            case NO_PLAN_EXISTS -> "no plan exists, %.0f ms";
            case GAVE_UP -> "without a plan after %.0f ms";
            case STOPPED -> "without a plan stopped after %.0f ms";
          };
      return String.format(Locale.ROOT, words, passedMilliseconds);
    }
  }

  /** Solves the problem; empty when it is not installed. */
  Optional<Outcome> solve(String domain, String problem) {
    return program.map(found -> solve(found, domain, problem));
  }

  private Outcome solve(Path found, String domain, String problem) {
    try {
      Path folder = Files.createTempDirectory("maestro-bench");
      try {
        Files.writeString(folder.resolve("domain.pddl"), domain);
        Files.writeString(folder.resolve("problem.pddl"), problem);
        return solve(found, folder);
      } finally {
        delete(folder);
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Outcome solve(Path found, Path folder) throws IOException {
    long start = System.nanoTime();
    Process process =
        new ProcessBuilder(kind.command(found, deadlineSeconds))
            .directory(folder.toFile())
            .redirectOutput(ProcessBuilder.Redirect.DISCARD)
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      long patience = (long) ((deadlineSeconds + GRACE_SECONDS) * 1000);
      boolean ended = process.waitFor(patience, TimeUnit.MILLISECONDS);
      double passed = (System.nanoTime() - start) / 1e6;
      if (!ended || passed > deadlineSeconds * 1000) {
        return new Outcome(End.STOPPED, passed);
      }
      boolean solved = process.exitValue() == 0 && Files.exists(folder.resolve(PLAN_FILE));
      boolean refuted = kind.saysThatNoneExists(process.exitValue());
      return new Outcome(solved ? End.PLAN : refuted ? End.NO_PLAN_EXISTS : End.GAVE_UP, passed);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return new Outcome(End.STOPPED, (System.nanoTime() - start) / 1e6);
    } finally {
      process.descendants().forEach(ProcessHandle::destroyForcibly);
      process.destroyForcibly();
    }
  }

  private static void delete(Path folder) throws IOException {
    List<Path> all = new ArrayList<>();
    try (Stream<Path> files = Files.walk(folder)) {
      files.sorted(Comparator.reverseOrder()).forEach(all::add);
    }
    for (Path file : all) {
      Files.deleteIfExists(file);
    }
  }
}
