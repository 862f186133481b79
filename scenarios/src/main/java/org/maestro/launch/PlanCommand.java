package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.math.BigDecimal;
import java.nio.file.AccessDeniedException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.Callable;
import java.util.concurrent.CancellationException;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingException;
import org.maestro.planning.ground.GrowingTask;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.ground.Patience;
import org.maestro.planning.pddl.PddlException;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;
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
  private static final int UNSOLVABLE = 10;
  private static final int NOTHING_FOUND = 12;
  private static final String MEMORY_USED_UP =
      "the memory is used up; give Java more (JAVA_TOOL_OPTIONS=-Xmx8g).";

  @Spec private CommandSpec spec;

  private final double javaStarted = System.currentTimeMillis() / 1e3;

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
      names = "--deadline",
      paramLabel = "S",
      description = "Seconds from the start of the process until the best plan so far is printed.")
  private double deadline = Double.POSITIVE_INFINITY;

  @Option(names = "--first", description = "Print the first plan found.")
  private boolean first;

  @Option(names = "--verbose", description = "Tell on stderr how far planning came.")
  private boolean verbose;

  @Override
  public Integer call() {
    if (!(deadline > 0)) {
      throw CommandException.badInput("The deadline has to be more than 0 seconds.");
    }
    if (problem.strip().startsWith("(")) {
      return new HomePlan(spec.commandLine().getOut()).show(domain, problem, pddl);
    }
    if (pddl.isPresent()) {
      throw CommandException.badInput(
          "--pddl goes with a home and a goal, as in: plan bob \"(nextTo Cup Bob)\" --pddl DIR.");
    }
    Patience patience = Patience.seconds(deadline - sinceStart(), () -> false);
    try {
      LiftedTask lifted = PddlReader.read(Path.of(domain), Path.of(problem));
      tell("read");
      GrowingTask task = Grounder.growing(lifted, patience);
      tell("%d operators at first".formatted(task.task().operators().size()));
      long memory = Runtime.getRuntime().maxMemory() / 10 * 6;
      AnytimePlanner planner = new AnytimePlanner(task, memory, this::tell);
      Solution solution = first ? planner.first(patience) : planner.solve(patience);
      return print(task.task(), solution);
    } catch (PddlException | GroundingException e) {
      throw CommandException.badInput(e.getMessage());
    } catch (CancellationException e) {
      spec.commandLine()
          .getOut()
          .println("; no plan found in time: the problem is still being made ground");
      return NOTHING_FOUND;
    } catch (OutOfMemoryError e) {
      spec.commandLine().getOut().println("; no plan found: " + MEMORY_USED_UP);
      return NOTHING_FOUND;
    } catch (NoSuchFileException e) {
      throw CommandException.badInput("There is no file %s.".formatted(e.getMessage()));
    } catch (AccessDeniedException e) {
      throw CommandException.badInput("%s may not be read.".formatted(e.getMessage()));
    } catch (InvalidPathException e) {
      throw CommandException.badInput("No file can be called '%s'.".formatted(e.getInput()));
    } catch (IOException e) {
      throw CommandException.badInput(e.getMessage());
    }
  }

  private void tell(String progress) {
    if (verbose) {
      spec.commandLine().getErr().printf(Locale.ROOT, "%.2f s: %s%n", sinceStart(), progress);
    }
  }

  private int print(GroundTask task, Solution solution) {
    PrintWriter out = spec.commandLine().getOut();
    PrintWriter err = spec.commandLine().getErr();
    int exit = 0;
    if (solution.hasPlan()) {
      for (GroundOperator operator : solution.operators()) {
        String step = task.names().operator(operator);
        if (!step.isEmpty()) {
          out.println(step);
        }
      }
      boolean optimal = solution.verdict() == Solution.Verdict.OPTIMAL;
      out.printf(
          "; cost = %s (%s)%n",
          number(solution.cost(), task),
          optimal ? "optimal" : "lower bound " + number(solution.lowerBound(), task));
    } else {
      exit = solution.verdict() == Solution.Verdict.UNSOLVABLE ? UNSOLVABLE : NOTHING_FOUND;
      out.println(
          switch (solution.verdict()) {
            case UNSOLVABLE -> "; unsolvable (proven)";
            case OUT_OF_MEMORY -> "; no plan found: " + MEMORY_USED_UP;
            default -> "; no plan found in time";
          });
    }
    out.flush();
    if (solution.memoryUsedUp() && solution.hasPlan()) {
      err.println("A cheaper plan or a proof may be missing: " + MEMORY_USED_UP);
    }
    Runtime runtime = Runtime.getRuntime();
    err.printf(
        Locale.ROOT,
        "%.2f s, %d MB%n",
        sinceStart(),
        (runtime.totalMemory() - runtime.freeMemory()) >> 20);
    err.flush();
    return exit;
  }

  private static String number(long units, GroundTask task) {
    return BigDecimal.valueOf(units).divide(task.unit()).stripTrailingZeros().toPlainString();
  }

  /** The launcher script says when it was called, as the machine takes its time to start Java. */
  private double sinceStart() {
    long micros = Long.getLong("maestro.started", 0);
    double beforeJava = micros == 0 ? 0 : javaStarted - micros / 1e6;
    return System.currentTimeMillis() / 1e3 - javaStarted + Math.max(0, beforeJava);
  }
}
