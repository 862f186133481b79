package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.Patience;
import org.maestro.planning.search.Solution.Verdict;

/**
 * Solves one ground task: the first plan by lazy greedy search, then cheaper ones and a lower bound
 * until both meet or patience is over. Not thread-safe.
 */
public final class AnytimePlanner {
  private static final int WEIGHT = 5;

  /** Of the time that is left, for each search that proves nothing. */
  private static final double SHARE = 0.1;

  private final SettledTask settled;
  private final GroundTask task;
  private final long memory;
  private final Consumer<String> progress;
  private Solution best = Solution.without(Verdict.OUT_OF_TIME, 0);

  /**
   * @param memory how many bytes searches may use, about
   * @param progress is told, for people, how far planning came
   */
  public AnytimePlanner(GroundTask task, long memory, Consumer<String> progress) {
    this.progress = progress;
    this.settled = new SettledTask(task);
    this.task = settled.task();
    this.memory = memory;
  }

  /** Solves the task until the cheapest plan is proven, or patience is over. */
  public Solution solve(Patience patience) {
    Solution first = first(patience);
    if (!first.hasPlan()) {
      return first;
    }
    try {
      for (int weight : new int[] {WEIGHT, 2, 1}) {
        star(weight, weight == 1 ? patience : patience.part(SHARE));
      }
    } catch (CancellationException e) {
      return best;
    }
    return best;
  }

  /** Solves the task until a plan is found, or none can exist, or patience is over. */
  public Solution first(Patience patience) {
    if (task.unreachable()) {
      return best = Solution.without(Verdict.UNSOLVABLE, 0);
    }
    try {
      double seconds = 0.5;
      while (best.verdict() == Verdict.OUT_OF_TIME) {
        greedy(patience.atMost(seconds));
        if (best.verdict() == Verdict.OUT_OF_TIME || best.verdict() == Verdict.OUT_OF_MEMORY) {
          star(WEIGHT, patience.atMost(seconds));
        }
        patience.refuseIfOver();
        seconds *= 2;
      }
    } catch (CancellationException e) {
      return best;
    }
    return best;
  }

  private void greedy(Patience patience) {
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
      progress.accept("greedy search was stopped");
    }
  }

  private void star(int weight, Patience patience) {
    if (best.verdict() == Verdict.OPTIMAL) {
      return;
    }
    long below = best.hasPlan() ? best.cost() : Leaf.INFINITE;
    try {
      BoundedRemoval.Result removed = BoundedRemoval.remove(task, below, patience);
      raise(removed.lowerBound());
      if (best.verdict() == Verdict.OPTIMAL) {
        return;
      }
      SearchTask reduced = new SearchTask(removed.task(), removed.task().operators());
      List<Leaf> leaves = Factoring.leaves(reduced, below, patience);
      progress.accept(
          "plan of cost %d, bound %d, %d of %d operators and %d facts left, leaves of %s states"
              .formatted(
                  best.cost(),
                  best.lowerBound(),
                  reduced.operators.size(),
                  task.operators().size(),
                  reduced.facts,
                  leaves.stream().map(leaf -> leaf.space.size()).toList()));
      star(
          new StarSearch(
              reduced, leaves, below, weight, memory, patience, plan -> keep(reduced, plan)));
    } catch (CancellationException e) {
      progress.accept("weight %d: stopped".formatted(weight));
    }
  }

  private void star(StarSearch search) {
    try {
      if (search.run() == StarSearch.End.EXHAUSTED && !best.hasPlan()) {
        best = Solution.without(Verdict.UNSOLVABLE, 0);
      }
    } finally {
      progress.accept(
          "%d states, bound %d, plan of cost %d"
              .formatted(search.states(), search.lowerBound(), best.cost()));
      raise(search.lowerBound());
    }
  }

  private void raise(long lowerBound) {
    if (!best.hasPlan()) {
      return;
    }
    long bound = Math.max(best.lowerBound(), Math.min(lowerBound, best.cost()));
    best =
        new Solution(
            bound >= best.cost() ? Verdict.OPTIMAL : Verdict.PLAN,
            best.operators(),
            best.cost(),
            bound);
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
    best = new Solution(Verdict.PLAN, settled.meant(operators), cost, best.lowerBound());
  }
}
