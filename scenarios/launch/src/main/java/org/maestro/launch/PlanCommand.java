package org.maestro.launch;

import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.Callable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** Solves a planning problem in PDDL, without a platform. */
@Command(
    name = "plan",
    description = "Solve a planning problem in PDDL, or show the plan for a home's goal.",
    exitCodeListHeading = "%nExit codes:%n",
    exitCodeList = {
      "0:a plan",
      "2:bad input",
      "10:proven that there is no plan",
      "12:no plan found in time, or in memory"
    })
final class PlanCommand implements Callable<Integer> {
  @Spec private CommandSpec spec;

  @Parameters(
      index = "0",
      paramLabel = "DOMAIN.pddl",
      description = "The domain, also gzipped; or a home file, or a shipped home: bob, arena.")
  private String domain;

  @Parameters(
      index = "1",
      paramLabel = "PROBLEM.pddl",
      description = "The problem, also gzipped; or a home's goal, such as \"(nextTo Cup Bob)\".")
  private String problem;

  @Option(
      names = "--pddl",
      paramLabel = "DIR",
      description = "Write what the platform would solve for the home's goal, as PDDL.")
  private Optional<Path> pddl = Optional.empty();

  @Option(
      names = "--pddl-plus",
      paramLabel = "DIR",
      description = "The same as PDDL+, in which steps take their time.")
  private Optional<Path> timedPddl = Optional.empty();

  @Option(
      names = "--deadline",
      paramLabel = "S",
      description = "Seconds from the start of the process until the best plan so far is printed.")
  private double deadline = Double.POSITIVE_INFINITY;

  @Option(names = "--first", description = "Print the first plan found.")
  private boolean first;

  @Option(names = "--verbose", description = "Tell on stderr how far planning came.")
  private boolean verbose;

  @Option(names = "--json", description = "Print one JSON document.")
  private boolean json;

  @Override
  public Integer call() {
    if (!(deadline > 0)) {
      throw CommandException.badInput("The deadline has to be more than 0 seconds.");
    }
    if (problem.strip().startsWith("(") || Shipped.isHome(domain)) {
      if (first || verbose || Double.isFinite(deadline)) {
        throw CommandException.badInput(
            "--deadline, --first and --verbose go with a problem in PDDL; a home's goal is planned"
                + " as the platform plans it.");
      }
      if (pddl.isPresent() && timedPddl.isPresent()) {
        throw CommandException.badInput("--pddl and --pddl-plus write the same files; give one.");
      }
      return new HomePlan(spec.commandLine().getOut(), timedPddl.isPresent())
          .show(domain, problem, pddl.or(() -> timedPddl), json);
    }
    if (pddl.isPresent() || timedPddl.isPresent()) {
      throw CommandException.badInput(
          "--pddl and --pddl-plus go with a home and a goal, as in:"
              + " plan bob \"(nextTo Cup Bob)\" --pddl DIR.");
    }
    return new PddlSolving(
            new PddlSolving.Asked(domain, problem, deadline, first, verbose, json),
            spec.commandLine().getOut(),
            spec.commandLine().getErr())
        .solve();
  }
}
