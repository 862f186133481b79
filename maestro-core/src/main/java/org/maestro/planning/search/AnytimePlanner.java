package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Patience;
import org.maestro.planning.search.Solution.Verdict;

/**
 * Solves one ground task: the first plan by lazy greedy search, then cheaper ones and a lower bound
 * until both meet or patience is over. Not thread-safe.
 */
public final class AnytimePlanner {
  private final GroundTask task;
  private final long memory;
  private Solution best = Solution.without(Verdict.OUT_OF_TIME, 0);

  /**
   * @param memory how many bytes searches may use, about
   */
  public AnytimePlanner(GroundTask task, long memory) {
    this.task = task;
    this.memory = memory;
  }

  /** Solves the task until the cheapest plan is proven, or patience is over. */
  public Solution solve(Patience patience) {
    try {
      return first(patience);
    } catch (CancellationException e) {
      return best;
    }
  }

  /** Solves the task until a plan is found, or none can exist, or patience is over. */
  public Solution first(Patience patience) {
    if (task.unreachable()) {
      return best = Solution.without(Verdict.UNSOLVABLE, 0);
    }
    try {
      SearchTask reduced = new SearchTask(task, Reduction.reduced(task).operators());
      long[] costs = Arrays.stream(reduced.cost).map(cost -> cost + one()).toArray();
      RelaxedPlan heuristic = new RelaxedPlan(reduced, costs, patience);
      LazyGreedySearch search = new LazyGreedySearch(reduced, heuristic, patience, memory);
      Optional<List<Integer>> plan = search.run(0, Long.MAX_VALUE);
      if (plan.isPresent()) {
        keep(reduced, plan.get());
      } else {
        best =
            Solution.without(
                search.isOutOfMemory() ? Verdict.OUT_OF_MEMORY : Verdict.UNSOLVABLE, 0);
      }
    } catch (CancellationException e) {
      return best;
    }
    return best;
  }

  private long one() {
    return task.unit().longValueExact();
  }

  private void keep(SearchTask reduced, List<Integer> plan) {
    List<GroundOperator> operators = new ArrayList<>();
    long cost = 0;
    for (int operator : plan) {
      operators.add(reduced.operators.get(operator));
      cost += reduced.cost[operator];
    }
    best = new Solution(Verdict.PLAN, operators, cost, best.lowerBound());
  }
}
