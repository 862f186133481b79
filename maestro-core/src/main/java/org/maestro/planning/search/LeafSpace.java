package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask.Bound;
import org.maestro.planning.ground.GroundingBudget;

/**
 * All states of one component whose operators look at nothing but itself and the centre: the places
 * of a robot, the light of a room. Made once; prices run over it.
 */
final class LeafSpace {
  private final SearchTask task;
  private final int[] facts;
  private final int[] sums;
  private final int[] operators;
  private final Map<Integer, Integer> local = new HashMap<>();
  private final StateTable table;
  private int[][] targets = new int[64][];
  private int[][] steps = new int[64][];

  /** The facts outside that each of the task's operators here needs. */
  private final Map<Integer, int[]> gates = new HashMap<>();

  private LeafSpace(SearchTask task, Components.Component component) {
    this.task = task;
    this.facts = component.facts();
    this.sums = component.sums();
    this.operators = component.operators();
    for (int i = 0; i < facts.length; i++) {
      local.put(facts[i], i);
    }
    for (int o : operators) {
      gates.put(
          o, Arrays.stream(task.needed[o]).filter(fact -> !local.containsKey(fact)).toArray());
    }
    table = new StateTable((facts.length + 63) / 64 + sums.length);
  }

  /**
   * The states that can be reached for less than a price, as if every operator's needs outside were
   * fulfilled; empty when there are too many.
   */
  static Optional<LeafSpace> explore(
      SearchTask task,
      Components.Component component,
      long below,
      int mostStates,
      GroundingBudget patience) {
    LeafSpace space = new LeafSpace(task, component);
    return space.explore(below, mostStates, patience) ? Optional.of(space) : Optional.empty();
  }

  private boolean explore(long below, int mostStates, GroundingBudget patience) {
    int first = table.number(projection(task.initial));
    List<Long> prices = new ArrayList<>();
    prices.add(0L);
    IntHeap queue = new IntHeap();
    queue.add(0, first);
    List<Integer> open = new ArrayList<>();
    while (!queue.isEmpty()) {
      long now = queue.leastKey();
      int from = queue.removeLeast();
      if (now > prices.get(from) || from < targets.length && targets[from] != null) {
        continue;
      }
      patience.refuseIfOver();
      open.clear();
      List<Integer> used = new ArrayList<>();
      for (int o : operators) {
        patience.check();
        long reached = now + task.cost[o];
        if (reached >= below || !isApplicable(table.state(from), o)) {
          continue;
        }
        int to = table.number(after(table.state(from), o));
        if (to == from) {
          continue;
        }
        if (to == prices.size()) {
          if (table.size() > mostStates) {
            return false;
          }
          prices.add(reached);
          queue.add(reached, to);
        } else if (reached < prices.get(to)) {
          prices.set(to, reached);
          queue.add(reached, to);
        }
        open.add(to);
        used.add(o);
      }
      if (from >= targets.length) {
        targets = Arrays.copyOf(targets, Math.max(table.size(), 2 * targets.length));
        steps = Arrays.copyOf(steps, targets.length);
      }
      targets[from] = open.stream().mapToInt(i -> i).toArray();
      steps[from] = used.stream().mapToInt(i -> i).toArray();
    }
    return true;
  }

  private long[] projection(long[] state) {
    int words = (facts.length + 63) / 64;
    long[] projected = new long[words + sums.length];
    for (int i = 0; i < facts.length; i++) {
      if (SearchTask.holds(state, facts[i])) {
        SearchTask.set(projected, i);
      }
    }
    for (int i = 0; i < sums.length; i++) {
      projected[words + i] = state[task.words + sums[i]];
    }
    return projected;
  }

  private boolean isApplicable(long[] state, int o) {
    for (int fact : task.needed[o]) {
      Integer number = local.get(fact);
      if (number != null && !SearchTask.holds(state, number)) {
        return false;
      }
    }
    return keepsAll(state, task.operators.get(o).bounds());
  }

  private boolean keepsAll(long[] state, int[] bounds) {
    for (int b : bounds) {
      Bound bound = task.origin.bounds().get(b);
      int at = Arrays.binarySearch(sums, bound.sum());
      if (at >= 0 && !bound.holds(state[state.length - sums.length + at])) {
        return false;
      }
    }
    return true;
  }

  private long[] after(long[] state, int o) {
    long[] after = state.clone();
    for (int fact : task.deleted[o]) {
      SearchTask.clear(after, local(fact));
    }
    for (int fact : task.added[o]) {
      SearchTask.set(after, local(fact));
    }
    GroundOperator operator = task.operators.get(o);
    for (int i = 0; i < operator.changedSums().length; i++) {
      int at = Arrays.binarySearch(sums, operator.changedSums()[i]);
      after[after.length - sums.length + at] += operator.changes()[i];
    }
    return after;
  }

  /** The number here of a fact that is of this component, as all are that its operators change. */
  private int local(int fact) {
    return Objects.requireNonNull(local.get(fact));
  }

  int size() {
    return table.size();
  }

  /** The states that one leads to by its {@link #steps}. */
  int[] targets(int state) {
    return targets[state];
  }

  /** The operators that lead from a state to its {@link #targets}. */
  int[] steps(int state) {
    return steps[state];
  }

  /** The facts outside that one of the operators here needs. */
  int[] gates(int operator) {
    return Objects.requireNonNull(gates.get(operator));
  }

  /** All facts outside that some operator needs, ascending. */
  int[] gates() {
    return gates.values().stream().flatMapToInt(Arrays::stream).distinct().sorted().toArray();
  }

  boolean concerns(int fact) {
    return local.containsKey(fact);
  }

  boolean concernsSum(int sum) {
    return Arrays.binarySearch(sums, sum) >= 0;
  }

  /** Whether a state has what a condition asks of this component. */
  boolean fulfils(int state, int[] needed, int[] bounds) {
    for (int fact : needed) {
      Integer number = local.get(fact);
      if (number != null && !SearchTask.holds(table.state(state), number)) {
        return false;
      }
    }
    return keepsAll(table.state(state), bounds);
  }

  /** The task's relaxed facts, with bounds, that hold in a state. */
  int[] relaxedFacts(int state) {
    List<Integer> holding = new ArrayList<>();
    for (int i = 0; i < facts.length; i++) {
      if (SearchTask.holds(table.state(state), i)) {
        holding.add(facts[i]);
      }
    }
    for (int b = 0; b < task.origin.bounds().size(); b++) {
      if (concernsSum(task.origin.bounds().get(b).sum())
          && keepsAll(table.state(state), new int[] {b})) {
        holding.add(task.facts + b);
      }
    }
    return holding.stream().mapToInt(i -> i).toArray();
  }
}
