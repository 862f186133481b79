package org.maestro.launch;

import java.io.IOException;
import java.io.PrintWriter;
import java.math.BigDecimal;
import java.nio.file.AccessDeniedException;
import java.nio.file.InvalidPathException;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Supplier;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.GroundingException;
import org.maestro.planning.ground.GrowingTask;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.pddl.PddlException;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;
import org.maestro.planning.unsolvable.Unsolvable;

/** Solves a planning problem in PDDL and prints what comes of it. */
final class PddlSolving {
  private static final int UNSOLVABLE = 10;
  private static final int NOTHING_FOUND = 12;

  /** It is known by then that there is no plan; why is worth some more of them. */
  private static final double SECONDS_FOR_REASONS = 10;

  private static final String MEMORY_USED_UP =
      "the memory is used up; give Java more (JAVA_TOOL_OPTIONS=-Xmx8g).";

  /**
   * @param domain its file, also gzipped
   * @param problem its file, also gzipped
   * @param deadlineSeconds from the start of the process, above 0; infinite: none
   * @param first whether the first plan will do
   * @param verbose whether to tell how far planning came
   * @param json whether to print one JSON document
   */
  record Asked(
      String domain,
      String problem,
      double deadlineSeconds,
      boolean first,
      boolean verbose,
      boolean json) {

    /**
     * Reads the arguments that most callers write. To have a library read them takes half the time
     * that a small problem needs, so that one is left to it which has anything else.
     */
    static Optional<Asked> plain(String... arguments) {
      String[] files = new String[2];
      int count = 0;
      double deadline = Double.POSITIVE_INFINITY;
      boolean first = false;
      for (int i = 0; i < arguments.length; i++) {
        String argument = arguments[i];
        if (argument.equals("--first")) {
          first = true;
        } else if (argument.equals("--deadline") && i + 1 < arguments.length) {
          deadline = seconds(arguments[++i]);
        } else if (!argument.startsWith("-") && !argument.startsWith("(") && count < 2) {
          files[count++] = argument;
        } else {
          return Optional.empty();
        }
      }
      return count < 2 || !(deadline > 0)
          ? Optional.empty()
          : Optional.of(new Asked(files[0], files[1], deadline, first, false, false));
    }

    private static double seconds(String text) {
      try {
        return Double.parseDouble(text);
      } catch (NumberFormatException e) {
        return Double.NaN;
      }
    }
  }

  private final double javaStarted = System.currentTimeMillis() / 1e3;
  private final Asked asked;
  private final PrintWriter out;
  private final PrintWriter err;

  PddlSolving(Asked asked, PrintWriter out, PrintWriter err) {
    this.asked = asked;
    this.out = out;
    this.err = err;
  }

  /**
   * @return the exit code
   * @throws CommandException when a file cannot be read, or has what is not understood
   */
  int solve() {
    GroundingBudget patience =
        GroundingBudget.seconds(asked.deadlineSeconds() - sinceStart(), () -> false);
    try {
      LiftedTask lifted = PddlReader.read(Path.of(asked.domain()), Path.of(asked.problem()));
      tell(() -> "read");
      GrowingTask task = Grounder.growing(lifted, patience);
      tell(() -> "%d operators at first".formatted(task.task().operators().size()));
      long memory = Runtime.getRuntime().maxMemory() / 10 * 6;
      AnytimePlanner planner = new AnytimePlanner(task, memory, this::tell);
      Solution solution = asked.first() ? planner.first(patience) : planner.solve(patience);
      int exit = exitCode(solution);
      if (!asked.json()) {
        print(task.task(), solution);
      }
      List<String> reasons =
          exit == UNSOLVABLE
              ? Unsolvable.reasons(lifted, patience.atMost(SECONDS_FOR_REASONS))
              : List.of();
      if (asked.json()) {
        out.println(PddlPlanDocument.of(asked, task.task(), solution, reasons));
      } else {
        reasons.forEach(reason -> out.println("; " + reason));
      }
      out.flush();
      tellEffort();
      return exit;
    } catch (PddlException | GroundingException e) {
      throw CommandException.badInput(e);
    } catch (CancellationException e) {
      return nothing(" in time: the problem is still being made ground");
    } catch (OutOfMemoryError e) {
      return nothing(": " + MEMORY_USED_UP);
    } catch (NoSuchFileException e) {
      throw CommandException.badInput("There is no file %s.".formatted(e.getMessage()));
    } catch (AccessDeniedException e) {
      throw CommandException.badInput("%s may not be read.".formatted(e.getMessage()));
    } catch (InvalidPathException e) {
      throw CommandException.badInput("No file can be called '%s'.".formatted(e.getInput()));
    } catch (IOException e) {
      throw CommandException.badInput(e);
    }
  }

  private void tell(Supplier<String> progress) {
    if (asked.verbose()) {
      err.printf(Locale.ROOT, "%.2f s: %s%n", sinceStart(), progress.get());
    }
  }

  private int nothing(String why) {
    String sentence = "no plan found" + why;
    out.println(asked.json() ? PddlPlanDocument.without(asked, sentence) : "; " + sentence);
    return NOTHING_FOUND;
  }

  private static int exitCode(Solution solution) {
    if (solution.hasPlan()) {
      return 0;
    }
    return solution.verdict() == Solution.Verdict.UNSOLVABLE ? UNSOLVABLE : NOTHING_FOUND;
  }

  static String noPlan(Solution solution) {
    return switch (solution.verdict()) {
      case UNSOLVABLE -> "unsolvable (proven)";
      case OUT_OF_MEMORY -> "no plan found: " + MEMORY_USED_UP;
      default -> "no plan found in time";
    };
  }

  private void print(GroundTask task, Solution solution) {
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
      out.println("; " + noPlan(solution));
    }
    out.flush();
    if (solution.memoryUsedUp() && solution.hasPlan()) {
      err.println("A cheaper plan or a proof may be missing: " + MEMORY_USED_UP);
    }
  }

  private void tellEffort() {
    Runtime runtime = Runtime.getRuntime();
    err.printf(
        Locale.ROOT,
        "%.2f s, %d MB%n",
        sinceStart(),
        (runtime.totalMemory() - runtime.freeMemory()) >> 20);
    err.flush();
  }

  static BigDecimal amount(long units, GroundTask task) {
    return BigDecimal.valueOf(units).divide(task.unit()).stripTrailingZeros();
  }

  private static String number(long units, GroundTask task) {
    return amount(units, task).toPlainString();
  }

  /** The launcher script says when it was called, as the machine takes its time to start Java. */
  private double sinceStart() {
    long micros = Long.getLong("maestro.started", 0);
    double beforeJava = micros == 0 ? 0 : javaStarted - micros / 1e6;
    return System.currentTimeMillis() / 1e3 - javaStarted + Math.max(0, beforeJava);
  }
}
