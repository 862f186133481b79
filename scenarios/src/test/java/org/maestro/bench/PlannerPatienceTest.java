package org.maestro.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.nio.charset.StandardCharsets;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Test;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.ground.Patience;
import org.maestro.planning.pddl.PddlReader;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/** Planning ends when it is told to, and when it has no more room, with what it has by then. */
class PlannerPatienceTest {
  private static final long MEMORY = 500_000_000;

  /** What is not compiled yet is slow. */
  private static final int ATTEMPTS = 5;

  /** Measures, on the planning thread, the time it works between two looks at who may cancel it. */
  private static final class Watch implements BooleanSupplier {
    private final ThreadMXBean threads = ManagementFactory.getThreadMXBean();
    private final double cancelAfterSeconds;
    private final long start = threads.getCurrentThreadCpuTime();
    private long last = start;
    private long longest;

    private Watch(double cancelAfterSeconds) {
      this.cancelAfterSeconds = cancelAfterSeconds;
    }

    @Override
    public boolean getAsBoolean() {
      long now = threads.getCurrentThreadCpuTime();
      longest = Math.max(longest, now - last);
      last = now;
      return now - start > cancelAfterSeconds * 1e9;
    }

    private double longestMilliseconds() {
      return longest / 1e6;
    }

    private double millisecondsSinceLast() {
      return (threads.getCurrentThreadCpuTime() - last) / 1e6;
    }
  }

  @Test
  void endsWithinTwentyMillisecondsWhenCancelled() throws IOException {
    LiftedTask task = task(300, PlanningHome.Wish.THREE_TRANSPORTS);
    double longest = Double.MAX_VALUE;
    for (int attempt = 0; attempt < ATTEMPTS && longest >= 20; attempt++) {
      Watch watch = new Watch(0.8);
      Solution solution = plan(task, watch);
      longest = Math.max(watch.longestMilliseconds(), watch.millisecondsSinceLast());
      assertThat(solution.hasPlan()).isTrue();
      assertThat(solution.lowerBound()).isPositive().isLessThanOrEqualTo(solution.cost());
    }
    assertThat(longest).isLessThan(20);
  }

  private static Solution plan(LiftedTask task, BooleanSupplier cancelled) {
    Patience patience = Patience.seconds(Double.POSITIVE_INFINITY, cancelled);
    return new AnytimePlanner(Grounder.growing(task, patience), MEMORY, line -> {}).solve(patience);
  }

  @Test
  void keepsItsPlanWhenMemoryIsUsedUp() throws IOException {
    GroundTask task =
        Grounder.ground(task(100, PlanningHome.Wish.THREE_TRANSPORTS), Patience.endless());
    Solution solution = new AnytimePlanner(task, 500_000, line -> {}).solve(Patience.endless());
    assertThat(solution.memoryUsedUp()).isTrue();
    assertThat(solution.verdict()).isEqualTo(Solution.Verdict.PLAN);
    assertThat(solution.lowerBound()).isPositive().isLessThan(solution.cost());
  }

  private static LiftedTask task(int agents, PlanningHome.Wish wish) throws IOException {
    try (InputStream in =
        PlannerPatienceTest.class.getResourceAsStream("/planning/home-domain.pddl")) {
      String domain = new String(in.readAllBytes(), StandardCharsets.UTF_8);
      return PddlReader.parse(
          "domain", domain, "problem", new PlanningHome(agents, 3).problem(wish));
    }
  }
}
