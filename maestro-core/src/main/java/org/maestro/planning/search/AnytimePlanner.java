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
 * until both meet, patience is over or memory is used up. Not thread-safe.
 */
public final class AnytimePlanner {
  private static final int WEIGHT = 5;

  /** Of the time that is left, for each search that proves nothing. */
  private static final double SHARE = 0.1;

  /** And no more than this. */
  private static final double MOST_SECONDS = 20;

  private final GroundTask origin;
  private final long memory;
  private final Consumer<String> progress;
  private Optional<SettledTask> settled = Optional.empty();
  private Solution best = Solution.without(Verdict.OUT_OF_TIME, 0);

  /**
   * @param memory how many bytes searches may use, about
   * @param progress is told, for people, how far planning came
   */
  public AnytimePlanner(GroundTask task, long memory, Consumer<String> progress) {
    this.progress = progress;
    this.origin = task;
    this.memory = memory;
  }

  /**
   * Solves the task until the cheapest plan is proven, or patience is over, or memory is used up.
   */
  public Solution solve(Patience patience) {
    Solution first = first(patience);
    if (!first.hasPlan()) {
      return first;
    }
    try {
      for (int weight : new int[] {WEIGHT, 2, 1}) {
        star(weight, weight == 1 ? patience : patience.part(SHARE).atMost(MOST_SECONDS));
        patience.refuseIfOver();
      }
    } catch (CancellationException e) {
      return best;
    } catch (OutOfMemoryError e) {
      // What the searches held is free again by now; what was found before is as good as ever.
      best = best.afterMemoryWasUsedUp();
    }
    return best;
  }

  /** Solves the task until a plan is found, or none can exist, or patience is over. */
  public Solution first(Patience patience) {
    if (origin.unreachable()) {
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
    } catch (OutOfMemoryError e) {
      best = best.afterMemoryWasUsedUp();
    }
    return best;
  }

  private SettledTask settled(Patience patience) {
    if (settled.isEmpty()) {
      settled = Optional.of(new SettledTask(origin, patience));
    }
    return settled.get();
  }

  private void greedy(Patience patience) {
    try {
      GroundTask task = settled(patience).task();
      SearchTask reduced =
          new SearchTask(task, Reduction.reduced(task, patience).operators(), patience);
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
      GroundTask task = settled(patience).task();
      BoundedRemoval.Result removed = BoundedRemoval.remove(task, below, patience);
      raise(removed.lowerBound());
      if (best.verdict() == Verdict.OPTIMAL) {
        return;
      }
      SearchTask reduced = new SearchTask(removed.task(), removed.task().operators(), patience);
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
      StarSearch.End end = search.run();
      if (end == StarSearch.End.OUT_OF_MEMORY) {
        best = best.afterMemoryWasUsedUp();
      } else if (!best.hasPlan()) {
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
            bound,
            best.memoryUsedUp());
  }

  private long one() {
    return origin.unit().longValueExact();
  }

  private void keep(SearchTask reduced, List<Integer> plan) {
    List<GroundOperator> operators = new ArrayList<>();
    long cost = 0;
    for (int operator : plan) {
      operators.add(reduced.operators.get(operator));
      cost += reduced.cost[operator];
    }
    List<GroundOperator> meant =
        settled.map(task -> task.meant(operators)).orElse(List.copyOf(operators));
    best = new Solution(Verdict.PLAN, meant, cost, best.lowerBound(), best.memoryUsedUp());
  }
}
