package org.maestro.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.TimeUnit;

/**
 * Fast Downward, as the Python package {@code up-fast-downward} brings it, if it is installed for
 * the {@code python3} of the path.
 */
final class Peer {
  private static final String WHERE =
      "import up_fast_downward, os; print(os.path.join(os.path.dirname(up_fast_downward.__file__),"
          + " 'downward', 'fast-downward.py'))";

  private final double deadlineSeconds;
  private final Optional<Path> program;

  Peer(double deadlineSeconds) {
    this.deadlineSeconds = deadlineSeconds;
    this.program = find();
  }

  private static Optional<Path> find() {
    try {
      Process python =
          new ProcessBuilder("python3", "-c", WHERE)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      String path = new String(python.getInputStream().readAllBytes()).strip();
      return path.isEmpty() ? Optional.empty() : Optional.of(Path.of(path)).filter(Files::exists);
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /**
   * Until it has proven the cheapest plan; empty when it has not by the deadline, or is missing.
   */
  OptionalDouble milliseconds(String domain, String problem) {
    if (program.isEmpty()) {
      return OptionalDouble.empty();
    }
    try {
      Path folder = Files.createTempDirectory("maestro-bench");
      Files.writeString(folder.resolve("domain.pddl"), domain);
      Files.writeString(folder.resolve("problem.pddl"), problem);
      long start = System.nanoTime();
      Process process =
          new ProcessBuilder(
                  List.of(
                      "python3",
                      program.get().toString(),
                      "--overall-time-limit",
                      (int) Math.ceil(deadlineSeconds) + "s",
                      "domain.pddl",
                      "problem.pddl",
                      "--search",
                      "astar(lmcut())"))
              .directory(folder.toFile())
              .redirectOutput(ProcessBuilder.Redirect.DISCARD)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
      boolean ended = process.waitFor((long) deadlineSeconds + 10, TimeUnit.SECONDS);
      process.destroy();
      double passed = (System.nanoTime() - start) / 1e6;
      return ended && process.exitValue() == 0 ? OptionalDouble.of(passed) : OptionalDouble.empty();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return OptionalDouble.empty();
    }
  }
}
