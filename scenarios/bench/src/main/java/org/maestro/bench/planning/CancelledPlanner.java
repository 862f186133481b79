package org.maestro.bench.planning;

import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.util.Locale;
import java.util.concurrent.CancellationException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.locks.LockSupport;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;

/**
 * The first planning of its process, cancelled: prints how many milliseconds of processor time it
 * still took, or "ended" when it was faster than the cancel.
 */
final class CancelledPlanner {
  private CancelledPlanner() {}

  /**
   * @param arguments the number of agents, what is wished, and the milliseconds of processor time
   *     after which it is cancelled
   */
  public static void main(String[] arguments) throws Exception {
    LiftedTask task = task(Integer.parseInt(arguments[0]), PlanningHome.Wish.valueOf(arguments[1]));
    long cancelAfterNanos = Long.parseLong(arguments[2]) * 1_000_000;
    ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    AtomicBoolean cancelled = new AtomicBoolean();
    CompletableFuture<Long> usedInAll = new CompletableFuture<>();
    Thread planning =
        new Thread(
            () -> {
              plan(task, GroundingBudget.seconds(30, cancelled::get));
              usedInAll.complete(threads.getCurrentThreadCpuTime());
            });
    planning.start();
    long used = 0;
    while (used >= 0 && used < cancelAfterNanos) {
      LockSupport.parkNanos(200_000);
      used = threads.getThreadCpuTime(planning.getId());
    }
    cancelled.set(true);
    planning.join();
    System.out.println(
        used < 0 ? "ended" : String.format(Locale.ROOT, "%.2f", (usedInAll.join() - used) / 1e6));
  }

  private static void plan(LiftedTask task, GroundingBudget patience) {
    try {
      new AnytimePlanner(Grounder.growing(task, patience), 500_000_000, line -> {}).solve(patience);
    } catch (CancellationException e) {
      // Cancelled before there was anything to search: that is what is measured.
    }
  }

  static LiftedTask task(int agents, PlanningHome.Wish wish) throws IOException {
    try (InputStream in =
        CancelledPlanner.class.getResourceAsStream("/planning/home-domain.pddl")) {
      return PddlReader.parse(
          "domain",
          new String(in.readAllBytes(), StandardCharsets.UTF_8),
          "problem",
          new PlanningHome(agents, 3).problem(wish));
    }
  }
}
