package org.maestro.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.time.Duration;
import java.util.List;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.launch.JavaProcess;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.ground.Patience;
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
    LiftedTask task = CancelledPlanner.task(300, PlanningHome.Wish.THREE_TRANSPORTS);
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

  /** A process that never planned before runs slowly what it runs: it looks more often for that. */
  @Tag("full")
  @ParameterizedTest
  @CsvSource({
    "100, TRANSPORT, 5",
    "100, TRANSPORT, 20",
    "100, ILLUMINATE, 35",
    "1000, ILLUMINATE, 50",
    "1000, TRANSPORT, 90",
    "100, THREE_TRANSPORTS, 160",
    "100, THREE_TRANSPORTS, 400",
    "1000, OBSERVE, 70",
    "1000, THREE_TRANSPORTS, 500"
  })
  void endsWithinTwentyMillisecondsInAFreshProcess(int agents, String wish, int afterMilliseconds)
      throws Exception {
    try (JavaProcess process =
        JavaProcess.start(
            CancelledPlanner.class.getName(),
            List.of(String.valueOf(agents), wish, String.valueOf(afterMilliseconds)))) {
      JavaProcess.Ended ended = process.await(Duration.ofSeconds(60));
      assertThat(ended.errors()).isEmpty();
      assertThat(Double.parseDouble(ended.output())).isLessThan(20);
    }
  }

  private static Solution plan(LiftedTask task, BooleanSupplier cancelled) {
    Patience patience = Patience.seconds(Double.POSITIVE_INFINITY, cancelled);
    return new AnytimePlanner(Grounder.growing(task, patience), MEMORY, line -> {}).solve(patience);
  }

  @Test
  void keepsItsPlanWhenMemoryIsUsedUp() throws IOException {
    GroundTask task =
        Grounder.ground(
            CancelledPlanner.task(100, PlanningHome.Wish.THREE_TRANSPORTS), Patience.endless());
    Solution solution = new AnytimePlanner(task, 500_000, line -> {}).solve(Patience.endless());
    assertThat(solution.memoryUsedUp()).isTrue();
    assertThat(solution.verdict()).isEqualTo(Solution.Verdict.PLAN);
    assertThat(solution.lowerBound()).isPositive().isLessThan(solution.cost());
  }
}
