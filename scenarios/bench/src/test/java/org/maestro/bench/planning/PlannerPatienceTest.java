package org.maestro.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.util.concurrent.CancellationException;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.LiftedTask;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/**
 * Planning ends when it is told to, and when it has no more room, with what it has by then. How
 * soon is measured by {@code ./maestro bench cancel}.
 */
class PlannerPatienceTest {
  private static final long MEMORY = 500_000_000;

  /** Each search that is under way looks once more, and gives up. */
  private static final long MOST_LOOKS_AFTERWARDS = 20;

  /** Cancelled at a look that is counted: while it is grounded, searched, improved. */
  @ParameterizedTest
  @CsvSource({
    "100, TRANSPORT, 1",
    "100, TRANSPORT, 20",
    "100, THREE_TRANSPORTS, 300",
    "300, THREE_TRANSPORTS, 3000",
    "1000, ILLUMINATE, 50"
  })
  void endsAtOnceWhenCancelled(int agents, PlanningHome.Wish wish, long look) throws IOException {
    LiftedTask task = CancelledPlanner.task(agents, wish);
    AtomicLong looks = new AtomicLong();
    GroundingBudget patience =
        GroundingBudget.seconds(Double.POSITIVE_INFINITY, () -> looks.incrementAndGet() >= look);
    try {
      Solution solution =
          new AnytimePlanner(Grounder.growing(task, patience), MEMORY, line -> {}).solve(patience);
      assertThat(solution.verdict()).isIn(Solution.Verdict.PLAN, Solution.Verdict.OUT_OF_TIME);
    } catch (CancellationException e) {
      assertThat(e).as("cancelled before there was anything to search").isNotNull();
    }
    assertThat(looks.get()).isBetween(look, look + MOST_LOOKS_AFTERWARDS);
  }

  @Test
  void tellsThePlanThatItHasWhenCancelled() throws IOException {
    LiftedTask task = CancelledPlanner.task(300, PlanningHome.Wish.THREE_TRANSPORTS);
    AtomicBoolean hasPlan = new AtomicBoolean();
    GroundingBudget patience = GroundingBudget.seconds(Double.POSITIVE_INFINITY, hasPlan::get);
    Solution solution =
        new AnytimePlanner(
                Grounder.growing(task, patience),
                MEMORY,
                line -> hasPlan.compareAndSet(false, line.get().contains("plan of cost")))
            .solve(patience);
    assertThat(solution.hasPlan()).isTrue();
    assertThat(solution.lowerBound()).isNotNegative().isLessThanOrEqualTo(solution.cost());
  }

  @Test
  void keepsItsPlanWhenMemoryIsUsedUp() throws IOException {
    GroundTask task =
        Grounder.ground(
            CancelledPlanner.task(100, PlanningHome.Wish.THREE_TRANSPORTS),
            GroundingBudget.endless());
    Solution solution =
        new AnytimePlanner(task, 500_000, line -> {}).solve(GroundingBudget.endless());
    assertThat(solution.memoryUsedUp()).isTrue();
    assertThat(solution.verdict()).isEqualTo(Solution.Verdict.PLAN);
    assertThat(solution.lowerBound()).isPositive().isLessThan(solution.cost());
  }
}
