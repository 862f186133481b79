package org.maestro.planning.search;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.OptionalLong;
import java.util.Random;
import java.util.concurrent.atomic.AtomicInteger;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import net.jqwik.api.constraints.LongRange;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.search.Solution.Verdict;

/** Whenever planning is stopped, what it says is true. */
class StoppedPlanningTest {
  private static final long MEMORY = 200_000_000;

  @Property(tries = 600)
  void whatIsSaidIsProven(
      @ForAll @LongRange(min = 0, max = 1_000_000) long seed,
      @ForAll @IntRange(min = 0, max = 60) int asked) {
    GroundTask task = RandomTasksTest.task(new Random(seed), seed % 3 == 0);
    OptionalLong least = RandomTasksTest.leastCost(task);
    AtomicInteger left = new AtomicInteger(asked);
    GroundingBudget patience = GroundingBudget.seconds(1000, () -> left.decrementAndGet() < 0);
    Solution solution = new AnytimePlanner(task, MEMORY, line -> {}).solve(patience);
    if (solution.verdict() == Verdict.UNSOLVABLE) {
      assertThat(least).isEmpty();
    } else if (solution.hasPlan()) {
      assertThat(least.getAsLong()).isBetween(solution.lowerBound(), solution.cost());
      assertThat(solution.verdict() == Verdict.OPTIMAL)
          .isEqualTo(solution.lowerBound() == solution.cost());
    }
  }

  @Property(tries = 100)
  void littleMemoryMakesNothingUntrue(@ForAll @LongRange(min = 0, max = 1_000_000) long seed) {
    GroundTask task = RandomTasksTest.task(new Random(seed), seed % 3 == 0);
    OptionalLong least = RandomTasksTest.leastCost(task);
    Solution solution =
        new AnytimePlanner(task, 200 + seed % 3000, line -> {}).solve(GroundingBudget.endless());
    if (solution.hasPlan()) {
      assertThat(least.getAsLong()).isBetween(solution.lowerBound(), solution.cost());
    } else {
      assertThat(solution.verdict())
          .isIn(
              least.isEmpty() ? Verdict.UNSOLVABLE : Verdict.OUT_OF_MEMORY, Verdict.OUT_OF_MEMORY);
    }
  }
}
