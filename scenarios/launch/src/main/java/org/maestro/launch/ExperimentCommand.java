package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.stream.Collectors;
import org.maestro.experiment.Course;
import org.maestro.experiment.Experiment;
import org.maestro.experiment.Experiments;
import org.maestro.experiment.Findings;
import org.maestro.experiment.Request;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Carries out one of the papers' experiments and writes what it found. */
@Command(
    name = "experiment",
    description =
        "Carry out one of the papers' experiments: raw data, figures, and a page that compares.")
final class ExperimentCommand implements Callable<Integer> {
  private static final int MOST_RUNS = 100_000;

  @Spec private CommandSpec spec;

  @Parameters(
      arity = "0..1",
      paramLabel = "NAME",
      description = "Which experiment; without: what there is.")
  private Optional<String> name;

  @Option(names = "--runs", paramLabel = "N", description = "How many runs.")
  private Optional<Integer> runs;

  @Option(
      names = "--seed",
      paramLabel = "S",
      defaultValue = "1",
      description = "Of all chance: the same seed gives the same data; default ${DEFAULT-VALUE}.")
  private long seed;

  @Option(
      names = "--out",
      paramLabel = "DIR",
      description = "Where data, figures and page go; default: experiment-NAME.")
  private Optional<Path> directory;

  @Option(
      names = "--set",
      paramLabel = "name=value",
      description = "Set something of the world; the page lists what can be set.")
  private Map<String, String> given = new LinkedHashMap<>();

  @Option(
      names = "--affect",
      paramLabel = "on|off|both",
      description =
          "Whether the robot's voice is stressed when its battery is low, neutral, or each in turn"
              + " (exploration).")
  private Optional<String> affect;

  @Option(
      names = "--paced",
      description = "Also repeat 20 runs on the paced clock, over the real broker (move-object).")
  private boolean paced;

  @Mixin private SetUpOptions setUps = new SetUpOptions();

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    PrintWriter out = spec.commandLine().getOut();
    if (name.isEmpty()) {
      Experiments.all()
          .forEach(experiment -> out.printf("%-15s %s%n", experiment.name(), experiment.purpose()));
      return ExitCode.DONE;
    }
    Experiment experiment =
        setUps.of(
            Experiments.named(name.get())
                .orElseThrow(
                    () ->
                        CommandException.badInput(
                            "There is no experiment %s; there are %s."
                                .formatted(name.get(), names()))));
    affect.ifPresent(value -> given.put("affect", value));
    Experiments.Chosen chosen = Experiments.settings(experiment, given);
    chosen.notes().forEach(spec.commandLine().getErr()::println);
    Request request =
        new Request(checkedRuns(experiment), seed, chosen.settings(), checkedPaced(experiment));
    Path target = madeReady(directory.orElse(Path.of("experiment-" + experiment.name())));
    Course<?> course = experiment.begin(request);
    ProgressBar bar = new ProgressBar(spec.commandLine().getErr());
    Thread interruption = new Thread(() -> interrupted(course, target, bar), "interruption");
    Runtime.getRuntime().addShutdownHook(interruption);
    boolean isInterrupted;
    try {
      course.carryOut(bar);
    } finally {
      isInterrupted = isUnderWay(interruption);
    }
    if (isInterrupted) {
      return ExitCode.NOT_REACHED;
    }
    report(course, target);
    return ExitCode.DONE;
  }

  /** Whether the process is being ended, and tells by itself what was found. */
  private static boolean isUnderWay(Thread interruption) {
    try {
      Runtime.getRuntime().removeShutdownHook(interruption);
      return false;
    } catch (IllegalStateException e) {
      return true;
    }
  }

  /** What is finished is kept; the exit code is that of a process ended by a signal. */
  private void interrupted(Course<?> course, Path target, ProgressBar bar) {
    course.stop();
    bar.breakOff();
    PrintWriter err = spec.commandLine().getErr();
    err.println("Interrupted after %d of %d runs.".formatted(course.done(), course.runs()));
    try {
      if (course.done() > 0) {
        report(course, target);
      }
    } catch (RuntimeException e) {
      err.println("maestro: " + Failures.sentence(e));
    }
    err.flush();
  }

  private void report(Course<?> course, Path target) {
    PrintWriter out = spec.commandLine().getOut();
    Findings findings = course.findings();
    Path page = findings.write(target);
    if (json) {
      out.println(findings.json(target, course));
    } else {
      tell(findings, out);
      out.println("The page with figures and raw data beside it: " + page.toAbsolutePath());
    }
    out.flush();
  }

  private static void tell(Findings findings, PrintWriter out) {
    findings
        .summary()
        .ifPresentOrElse(
            told -> {
              new Table(told.table().columns(), told.table().rows()).print(out);
              told.sentences().forEach(out::println);
            },
            () -> findings.results().forEach(result -> out.println(result.line())));
  }

  /** Runs take long: that their data cannot be written is said before them. */
  private static Path madeReady(Path target) {
    if (Files.exists(target) && !Files.isDirectory(target)) {
      throw CommandException.badInput(
          "%s is a file; name a directory with --out.".formatted(target));
    }
    try {
      Files.createDirectories(target);
      Files.delete(Files.createTempFile(target, "maestro", null));
    } catch (IOException e) {
      throw CommandException.outside(
          "The directory %s cannot be written to; name another one with --out.".formatted(target),
          e);
    }
    return target;
  }

  private int checkedRuns(Experiment experiment) {
    int wanted = runs.orElse(experiment.usualRuns());
    if (wanted < 1 || wanted > MOST_RUNS) {
      throw CommandException.badInput(
          "--runs lies between 1 and %d, not at %d.".formatted(MOST_RUNS, wanted));
    }
    return wanted;
  }

  private boolean checkedPaced(Experiment experiment) {
    if (paced && !experiment.canBePaced()) {
      throw CommandException.badInput(
          "%s has no runs to repeat on the paced clock; leave --paced away."
              .formatted(experiment.name()));
    }
    return paced;
  }

  private static String names() {
    List<String> names = Experiments.all().stream().map(Experiment::name).toList();
    return names.stream().collect(Collectors.joining(", "));
  }
}
