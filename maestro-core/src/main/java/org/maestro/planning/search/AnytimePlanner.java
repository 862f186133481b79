package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CancellationException;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.GrowingTask;
import org.maestro.planning.search.Solution.Verdict;

/**
 * Solves one ground task: the first plan by lazy greedy search, then cheaper ones and a lower bound
 * until both meet, patience is over or memory is used up. It begins with what is cheaply reached,
 * and takes in the rest of the task as far as the plans known and the proof need it. Not
 * thread-safe.
 */
public final class AnytimePlanner {
  private static final int WEIGHT = 5;

  /** Of the time that is left, for each search that proves nothing. */
  private static final double SHARE = 0.1;

  /** And no more than this. */
  private static final double MOST_SECONDS = 20;

  /** For the first searches: they suffice for most tasks, and are in vain for the hardest. */
  private static final double SHORT_SECONDS = 0.2;

  private static final double SHORT_PROOF_SECONDS = 3;

  /** As long as there is more of the task, a search for a first plan ends with so many states. */
  private static final int MOST_STATES_OF_A_PART = 3000;

  /** What is cheaply reached, from one part to the next. */
  private static final int GROWTH = 2;

  /** A part of the operators is searched first if it is smaller than this part of all. */
  private static final double MOST_OF_ALL = 0.5;

  /** The result of a greedy search. */
  private enum Attempt {
    FOUND,
    /** There is no plan among the operators that were searched. */
    EXHAUSTED,
    TOO_LARGE,
    STOPPED
  }

  private final GrowingTask growing;
  private final long memory;
  private final Consumer<Supplier<String>> progress;
  private Optional<SettledTask> settled = Optional.empty();
  private Solution best = Solution.without(Verdict.OUT_OF_TIME, 0);

  /** Of one search: its states, each times the operators that an estimate of it looks at. */
  private long mostWork = Long.MAX_VALUE;

  private int mostStates = Integer.MAX_VALUE;

  /**
   * @param memory how many bytes searches may use, about
   * @param progress is told, for people, how far planning came; only who asks has it put in words,
   *     as the first time that takes longer than a cancel may
   */
  public AnytimePlanner(GroundTask task, long memory, Consumer<Supplier<String>> progress) {
    this(GrowingTask.whole(task), memory, progress);
  }

  /**
   * @param task grows when more of it is needed; costs of solutions are in its units at the end
   * @param memory how many bytes searches may use, about
   * @param progress is told, for people, how far planning came
   */
  public AnytimePlanner(GrowingTask task, long memory, Consumer<Supplier<String>> progress) {
    this.progress = progress;
    this.growing = task;
    this.memory = memory;
  }

  /**
   * Solves the task until the cheapest plan is proven, or patience is over, or memory is used up.
   */
  public Solution solve(GroundingBudget patience) {
    Solution first = first(patience);
    if (!first.hasPlan()) {
      return first;
    }
    try {
      if (!star(WEIGHT, patience.atMost(SHORT_SECONDS))) {
        grow(Math.min(best.cost(), further()), patience);
        star(2, patience.atMost(SHORT_SECONDS));
      }
      grow(best.cost(), patience);
      star(1, patience.atMost(SHORT_PROOF_SECONDS));
      for (int weight : new int[] {WEIGHT, 2}) {
        star(weight, patience.part(SHARE).atMost(MOST_SECONDS));
      }
      star(1, patience);
    } catch (CancellationException e) {
      return best;
    } catch (OutOfMemoryError e) {
      // What the searches held is free again by now; what was found before is as good as ever.
      best = best.afterMemoryWasUsedUp();
    }
    return best;
  }

  /**
   * Solves the task with searches each of which ends with so much work, however long that takes:
   * equal tasks have equal solutions on any machine.
   *
   * @param work states, each times the operators that an estimate of it looks at
   * @param states kept at once, whatever work they are
   */
  public Solution within(long work, int states) {
    mostWork = work;
    mostStates = states;
    GroundingBudget endless = GroundingBudget.endless();
    if (growing.task().unreachable()
        || greedy(MOST_STATES_OF_A_PART, endless) == Attempt.EXHAUSTED) {
      best = Solution.without(Verdict.UNSOLVABLE, 0);
      return best;
    }
    if (best.hasPlan() || !star(WEIGHT, endless) || best.hasPlan()) {
      star(1, endless);
    }
    return best;
  }

  /** Solves the task until a plan is found, or none can exist, or patience is over. */
  public Solution first(GroundingBudget patience) {
    try {
      while (!isWhole() && greedy(MOST_STATES_OF_A_PART, patience) != Attempt.FOUND) {
        grow(further(), patience);
      }
      if (growing.task().unreachable()) {
        best = Solution.without(Verdict.UNSOLVABLE, 0);
      } else if (!best.hasPlan()) {
        firstOfWhole(patience);
      }
    } catch (CancellationException e) {
      return best;
    } catch (OutOfMemoryError e) {
      best = best.afterMemoryWasUsedUp();
    }
    return best;
  }

  /** Each search in turn for longer, as which of them finds a plan cannot be foreseen. */
  private void firstOfWhole(GroundingBudget patience) {
    boolean mayGreedy = true;
    boolean mayStar = true;
    double seconds = 0.5;
    while (mayGreedy || mayStar) {
      if (mayGreedy) {
        Attempt attempt = greedy(Integer.MAX_VALUE, patience.atMost(seconds));
        mayGreedy = attempt == Attempt.STOPPED;
        if (attempt == Attempt.EXHAUSTED) {
          best = Solution.without(Verdict.UNSOLVABLE, 0);
        }
      }
      if (mayStar && hasNeither()) {
        star(WEIGHT, patience.atMost(seconds));
        mayStar = best.verdict() != Verdict.OUT_OF_MEMORY;
      }
      if (!hasNeither()) {
        return;
      }
      patience.refuseIfOver();
      seconds *= 2;
    }
    best = Solution.without(Verdict.OUT_OF_MEMORY, 0);
  }

  /** Neither a plan nor a proof that there is none. */
  private boolean hasNeither() {
    return !best.hasPlan() && best.verdict() != Verdict.UNSOLVABLE;
  }

  private boolean isWhole() {
    return growing.beyond() == Long.MAX_VALUE;
  }

  private long further() {
    return growing.beyond() < Long.MAX_VALUE / GROWTH
        ? GROWTH * Math.max(one(), growing.beyond())
        : Long.MAX_VALUE;
  }

  private void grow(long cost, GroundingBudget patience) {
    if (cost <= growing.beyond()) {
      return;
    }
    long unit = one();
    growing.grow(cost, patience);
    best = best.times(one() / unit);
    settled = Optional.empty();
    progress.accept(() -> "%d operators".formatted(growing.task().operators().size()));
  }

  private SettledTask settled(GroundingBudget patience) {
    if (settled.isEmpty()) {
      settled = Optional.of(new SettledTask(growing.task(), patience));
    }
    return settled.get();
  }

  private Attempt greedy(int states, GroundingBudget patience) {
    try {
      GroundTask task = Reduction.reduced(settled(patience).task(), patience);
      SearchTask reduced = new SearchTask(task, task.operators(), patience);
      RelaxedPlan heuristic = relaxedPlan(reduced, patience);
      List<GroundOperator> among = AmongThose.of(heuristic, reduced);
      if (among.size() < MOST_OF_ALL * reduced.operators.size()) {
        SearchTask small = new SearchTask(task, among, patience);
        RelaxedPlan ofSmall = relaxedPlan(small, patience);
        if (greedy(small, ofSmall, MOST_STATES_OF_A_PART, patience) == Attempt.FOUND) {
          return Attempt.FOUND;
        }
      }
      return greedy(reduced, heuristic, states, patience);
    } catch (CancellationException e) {
      progress.accept(() -> "greedy search was stopped");
      return Attempt.STOPPED;
    }
  }

  private RelaxedPlan relaxedPlan(SearchTask task, GroundingBudget patience) {
    long[] costs = Arrays.stream(task.cost).map(cost -> cost + one()).toArray();
    return new RelaxedPlan(task, costs, patience);
  }

  private Attempt greedy(
      SearchTask task, RelaxedPlan heuristic, int states, GroundingBudget patience) {
    LazyGreedySearch search =
        new LazyGreedySearch(task, heuristic, patience, memory, Math.min(states, affordable(task)));
    Optional<List<Integer>> plan = search.run(0, Long.MAX_VALUE);
    plan.ifPresent(found -> keep(task, found));
    if (plan.isPresent()) {
      return Attempt.FOUND;
    }
    return search.isOutOfMemory() ? Attempt.TOO_LARGE : Attempt.EXHAUSTED;
  }

  /** Whether what is there of the task was searched to its end. */
  private boolean star(int weight, GroundingBudget patience) {
    if (best.verdict() == Verdict.OPTIMAL) {
      return true;
    }
    patience.refuseIfOver();
    long below = best.hasPlan() ? best.cost() : Leaf.INFINITE;
    try {
      GroundTask task = settled(patience).task();
      BoundedRemoval.Result removed = BoundedRemoval.remove(task, below, patience);
      raise(removed.lowerBound());
      if (best.verdict() == Verdict.OPTIMAL) {
        return true;
      }
      SearchTask reduced = new SearchTask(removed.task(), removed.task().operators(), patience);
      List<Leaf> leaves = Factoring.leaves(reduced, below, patience);
      progress.accept(
          () ->
              "plan of cost %d, bound %d, %d of %d operators and %d facts left, leaves of %s states"
                  .formatted(
                      best.cost(),
                      best.lowerBound(),
                      reduced.operators.size(),
                      task.operators().size(),
                      reduced.facts,
                      leaves.stream().map(leaf -> leaf.space.size()).toList()));
      return star(
          new DecoupledSearch(
              reduced,
              leaves,
              below,
              weight,
              memory,
              affordable(reduced),
              patience,
              plan -> keep(reduced, plan)));
    } catch (CancellationException e) {
      progress.accept(() -> "weight %d: stopped".formatted(weight));
      return false;
    }
  }

  private int affordable(SearchTask task) {
    return (int) Math.min(mostStates, 1 + mostWork / (1 + task.operators.size()));
  }

  private boolean star(DecoupledSearch search) {
    try {
      DecoupledSearch.End end = search.run();
      if (end == DecoupledSearch.End.OUT_OF_MEMORY) {
        best = best.afterMemoryWasUsedUp();
      } else if (!best.hasPlan() && isWhole()) {
        best = Solution.without(Verdict.UNSOLVABLE, 0);
      }
      return end == DecoupledSearch.End.EXHAUSTED;
    } finally {
      progress.accept(
          () ->
              "%d states, bound %d, plan of cost %d"
                  .formatted(search.states(), search.lowerBound(), best.cost()));
      raise(search.lowerBound());
    }
  }

  private void raise(long lowerBound) {
    if (!best.hasPlan()) {
      return;
    }
    long proven = Math.min(lowerBound, growing.beyond());
    long bound = Math.max(best.lowerBound(), Math.min(proven, best.cost()));
    best =
        new Solution(
            bound >= best.cost() ? Verdict.OPTIMAL : Verdict.PLAN,
            best.operators(),
            best.cost(),
            bound,
            best.memoryUsedUp());
  }

  private long one() {
    return growing.task().unit().longValueExact();
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
    int last = reaching(meant);
    for (GroundOperator inVain : meant.subList(last, meant.size())) {
      cost -= inVain.cost();
    }
    Verdict verdict = cost <= best.lowerBound() ? Verdict.OPTIMAL : Verdict.PLAN;
    best =
        new Solution(verdict, meant.subList(0, last), cost, best.lowerBound(), best.memoryUsedUp());
  }

  /**
   * How many operators there are up to the one that reaches the goal by itself, if any does. Such a
   * one stands for what people asked, which what comes after it could undo.
   */
  private int reaching(List<GroundOperator> plan) {
    GroundTask task = growing.task();
    for (int i = 0; task.goalBounds().length == 0 && i < plan.size(); i++) {
      int[] added = plan.get(i).added();
      if (Arrays.stream(task.goal()).allMatch(fact -> Arrays.binarySearch(added, fact) >= 0)) {
        return i + 1;
      }
    }
    return plan.size();
  }
}
