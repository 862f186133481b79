package org.maestro.planning.search;

import java.util.Arrays;
import org.maestro.planning.ground.GroundingBudget;

/**
 * The FF heuristic: the cost of a plan that ignores what operators delete, made of the supporters
 * with the least sums of costs. Facts are reached in the order of their costs, and no farther than
 * the goal. Not thread-safe.
 */
final class RelaxedPlan {
  static final long INFINITE = Long.MAX_VALUE / 4;

  private static final int NONE = -1;

  private final SearchTask task;
  private final long[] costs;
  private final GroundingBudget patience;
  private final long[] value;
  private final int[] supporter;
  private final boolean[] closed;
  private final boolean[] marked;
  private final int[] open;
  private final int[] openAtFirst;
  private final long[] sum;
  private final boolean[] planned;
  private final int[] stack;
  private final IntHeap queue = new IntHeap();
  private int[] applicable = new int[64];
  private int applicableCount;
  private int[] plan = new int[64];
  private int planSize;
  private long[] state = {};

  /**
   * @param costs of operators, as the heuristic is to see them
   */
  RelaxedPlan(SearchTask task, long[] costs, GroundingBudget patience) {
    this.task = task;
    this.costs = costs;
    this.patience = patience;
    patience.refuseIfOver();
    value = new long[task.relaxedFacts];
    supporter = new int[task.relaxedFacts];
    closed = new boolean[task.relaxedFacts];
    marked = new boolean[task.relaxedFacts];
    stack = new int[task.relaxedFacts];
    openAtFirst = Arrays.stream(task.relaxedNeeded).mapToInt(needed -> needed.length).toArray();
    open = new int[openAtFirst.length];
    sum = new long[openAtFirst.length];
    planned = new boolean[openAtFirst.length];
  }

  /** The estimate from a state; infinite when not even the relaxed goal can be reached. */
  long estimate(long[] state) {
    this.state = state;
    explore();
    for (int i = 0; i < planSize; i++) {
      planned[plan[i]] = false;
    }
    planSize = 0;
    for (int fact : task.relaxedGoal) {
      if (value[fact] >= INFINITE) {
        return INFINITE;
      }
    }
    return extract();
  }

  /** The operators of the plan that the last estimate was made of, in no order. */
  int[] operators() {
    return Arrays.copyOf(plan, planSize);
  }

  /** How many operators can be applied in the state of the last estimate. */
  int applicableCount() {
    return applicableCount;
  }

  int applicable(int i) {
    return applicable[i];
  }

  /** Whether an operator is in the relaxed plan, so that it should be tried first. */
  boolean isPreferred(int operator) {
    return planned[operator];
  }

  private void explore() {
    Arrays.fill(value, INFINITE);
    Arrays.fill(closed, false);
    System.arraycopy(openAtFirst, 0, open, 0, open.length);
    Arrays.fill(sum, 0);
    queue.clear();
    applicableCount = 0;
    task.forEachFact(
        state,
        fact -> {
          value[fact] = 0;
          supporter[fact] = NONE;
          queue.add(0, fact);
        });
    for (int operator : task.withoutNeeds) {
      apply(operator);
    }
    int goals = task.relaxedGoal.length;
    while (!queue.isEmpty()) {
      long now = queue.leastKey();
      int fact = queue.removeLeast();
      if (closed[fact]) {
        continue;
      }
      if (now > 0 && goals == 0) {
        return;
      }
      closed[fact] = true;
      for (int goal : task.relaxedGoal) {
        goals -= goal == fact ? 1 : 0;
      }
      for (int operator : task.consumers[fact]) {
        sum[operator] += now;
        if (--open[operator] == 0) {
          apply(operator);
        }
      }
      patience.check();
    }
  }

  private void apply(int operator) {
    if (sum[operator] == 0 && task.isApplicable(state, operator)) {
      if (applicableCount == applicable.length) {
        applicable = Arrays.copyOf(applicable, 2 * applicableCount);
      }
      applicable[applicableCount++] = operator;
    }
    long reached = sum[operator] + costs[operator];
    for (int fact : task.relaxedAdded[operator]) {
      long whole = fact < task.facts ? reached : repeated(operator, fact, reached);
      if (whole < value[fact]) {
        value[fact] = whole;
        supporter[fact] = operator;
        queue.add(whole, fact);
      }
    }
  }

  /** A bound is reached by so many of the operator as its gap needs. */
  private long repeated(int operator, int fact, long reached) {
    int bound = fact - task.facts;
    int sumNumber = task.origin.bounds().get(bound).sum();
    var ground = task.operators.get(operator);
    int i = Arrays.binarySearch(ground.changedSums(), sumNumber);
    long change = Math.abs(ground.changes()[i]);
    long times = Math.max(1, (task.gap(state, bound) + change - 1) / change);
    return Math.min(INFINITE - 1, reached + (times - 1) * Math.max(1, costs[operator]));
  }

  private long extract() {
    Arrays.fill(marked, false);
    int size = 0;
    for (int fact : task.relaxedGoal) {
      if (!marked[fact]) {
        marked[fact] = true;
        stack[size++] = fact;
      }
    }
    long total = 0;
    while (size > 0) {
      int operator = supporter[stack[--size]];
      if (operator == NONE || planned[operator]) {
        continue;
      }
      planned[operator] = true;
      if (planSize == plan.length) {
        plan = Arrays.copyOf(plan, 2 * planSize);
      }
      plan[planSize++] = operator;
      total += costs[operator];
      for (int fact : task.relaxedNeeded[operator]) {
        if (!marked[fact]) {
          marked[fact] = true;
          stack[size++] = fact;
        }
      }
    }
    return total;
  }
}
