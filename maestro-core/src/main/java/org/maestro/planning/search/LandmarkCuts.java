package org.maestro.planning.search;

import java.util.Arrays;
import org.maestro.planning.ground.GroundingBudget;

/**
 * The landmark-cut lower bound (Helmert and Domshlak 2009) over a {@link SearchTask}, with costs in
 * whole units; where there are many operators, the cuts are made of coarse grains of the costs
 * first, then of finer ones. Sources may be added for each estimate: sets of facts that are had for
 * a price, as states of leaves are. Values are brought up to date after each cut instead of
 * computed anew. Not thread-safe.
 */
final class LandmarkCuts {
  static final long INFINITE = Long.MAX_VALUE / 4;

  /** Of so many, cuts of small parts of the costs take longer than they bring. */
  private static final int MANY_OPERATORS = 2_000;

  /** In what the goal costs at least at first. */
  private static final int FIRST_GRAINS = 32;

  private static final int FINER = 4;
  private static final int ROUNDS = 3;

  private final SearchTask task;
  private final long[] costs;
  private final GroundingBudget patience;
  private final int operators;
  private final int truth;
  private final int goal;
  private int[][] needed;
  private int[][] added;
  private final int[][] consumers;
  private final int[][] achievers;

  private final long[] value;
  private long[] rest;
  private int[] open;

  /** Of each operator that is reached the dearest fact that it needs; of the others none. */
  private int[] supporter;

  private long[] supporterValue;
  private int count;
  private final boolean[] inGoalZone;
  private final boolean[] inFrontZone;
  private final int[] stack;
  private int[] edge = new int[64];
  private int edgeSize;
  private boolean[] taken;
  private final int[] reachedBy;
  private final IntHeap queue = new IntHeap();
  private final int[] initial;
  private int initialCount;

  /**
   * @param costs of the task's operators, perhaps only a part of each
   */
  LandmarkCuts(SearchTask task, long[] costs, GroundingBudget patience) {
    this.task = task;
    this.costs = costs;
    this.patience = patience;
    int size = task.operators.size();
    operators = size + 1;
    truth = task.relaxedFacts;
    goal = truth + 1;
    needed = Arrays.copyOf(task.relaxedNeeded, operators);
    added = Arrays.copyOf(task.relaxedAdded, operators);
    for (int free : task.withoutNeeds) {
      needed[free] = new int[] {truth};
    }
    needed[size] = task.relaxedGoal.length == 0 ? new int[] {truth} : task.relaxedGoal;
    added[size] = new int[] {goal};
    patience.refuseIfOver();
    int facts = goal + 1;
    consumers = SearchTask.inverse(needed, facts);
    patience.refuseIfOver();
    achievers = SearchTask.inverse(added, facts);
    patience.refuseIfOver();
    value = new long[facts];
    inGoalZone = new boolean[facts];
    inFrontZone = new boolean[facts];
    stack = new int[facts];
    reachedBy = new int[facts];
    initial = new int[facts];
    resize(operators);
  }

  private void resize(int size) {
    rest = new long[size];
    taken = new boolean[size];
    open = new int[size];
    supporter = new int[size];
    supporterValue = new long[size];
    needed = Arrays.copyOf(needed, size);
    added = Arrays.copyOf(added, size);
  }

  /** Never more than what is left to pay from a state; infinite when the goal is out of reach. */
  long estimate(long[] state) {
    initialCount = 0;
    task.forEachFact(state, fact -> initial[initialCount++] = fact);
    count = operators;
    return estimate(INFINITE);
  }

  /** Starts an estimate from facts that are given one by one. */
  void begin() {
    initialCount = 0;
    count = operators;
    Arrays.fill(inFrontZone, false);
  }

  void addFact(int fact) {
    if (!inFrontZone[fact]) {
      inFrontZone[fact] = true;
      initial[initialCount++] = fact;
    }
  }

  /** Facts that are had together for a price. */
  void addSource(int[] facts, long price) {
    if (count == needed.length) {
      resize(2 * count);
    }
    needed[count] = new int[] {truth};
    added[count] = facts;
    rest[count++] = price;
  }

  /**
   * The estimate from what was given since {@link #begin}.
   *
   * @param enough to know that it is no less
   */
  long estimate(long enough) {
    System.arraycopy(costs, 0, rest, 0, costs.length);
    rest[costs.length] = 0;
    initial[initialCount++] = truth;
    computeValues();
    if (count <= MANY_OPERATORS) {
      return total(enough);
    }
    long total = 0;
    long grain = Math.max(1, value[goal] / FIRST_GRAINS);
    for (int round = 0; round < ROUNDS && isWorthMore(total, enough); round++) {
      long[] fine = withoutFine(grain);
      computeValues();
      total += total(enough - total);
      for (int o = 0; o < count; o++) {
        rest[o] += fine[o];
      }
      computeValues();
      grain = Math.max(1, grain / FINER);
    }
    return value[goal] >= INFINITE ? INFINITE : total;
  }

  private boolean isWorthMore(long total, long enough) {
    return value[goal] > 0 && value[goal] < INFINITE && total < enough;
  }

  /** Leaves of the costs whole grains, and returns the rest. */
  private long[] withoutFine(long grain) {
    long[] fine = new long[count];
    for (int o = 0; o < count; o++) {
      fine[o] = rest[o] % grain;
      rest[o] -= fine[o];
    }
    return fine;
  }

  /** What the cuts cost that are left to be made. */
  private long total(long enough) {
    long total = 0;
    while (true) {
      if (value[goal] >= INFINITE) {
        return INFINITE;
      }
      if (value[goal] == 0 || total >= enough) {
        return total;
      }
      markGoalZone();
      total += pay();
      patience.refuseIfOver();
    }
  }

  /** What an operator costs besides the cuts of the last estimate. */
  long rest(int operator) {
    return rest[operator];
  }

  /** The rests of what has to come before the operator, at least; infinite if out of reach. */
  long restBefore(int operator) {
    return open[operator] > 0 ? INFINITE : supporterValue[operator];
  }

  private void computeValues() {
    Arrays.fill(value, INFINITE);
    for (int o = 0; o < count; o++) {
      open[o] = needed[o].length;
      supporterValue[o] = -1;
      supporter[o] = -1;
    }
    queue.clear();
    for (int i = 0; i < initialCount; i++) {
      value[initial[i]] = 0;
      queue.add(0, initial[i]);
    }
    while (!queue.isEmpty()) {
      long now = queue.leastKey();
      int fact = queue.removeLeast();
      if (now > value[fact]) {
        continue;
      }
      patience.check();
      for (int o : consumers[fact]) {
        reach(o, fact, now);
      }
      for (int o = operators; fact == truth && o < count; o++) {
        reach(o, fact, now);
      }
    }
  }

  private void reach(int o, int fact, long now) {
    if (--open[o] == 0) {
      // Facts come in the order of their values: the last one is the dearest.
      supporter[o] = fact;
      supporterValue[o] = now;
      offer(o, now + rest[o]);
    }
  }

  private void offer(int o, long reached) {
    for (int fact : added[o]) {
      if (reached < value[fact]) {
        value[fact] = reached;
        reachedBy[fact] = o;
        queue.add(reached, fact);
      }
    }
  }

  private void markGoalZone() {
    Arrays.fill(inGoalZone, false);
    int size = 0;
    edgeSize = 0;
    inGoalZone[goal] = true;
    stack[size++] = goal;
    while (size > 0) {
      for (int o : achievers[stack[--size]]) {
        if (open[o] != 0 || inGoalZone[supporter[o]]) {
          continue;
        }
        if (rest[o] == 0) {
          inGoalZone[supporter[o]] = true;
          stack[size++] = supporter[o];
        } else {
          edge(o);
        }
      }
    }
    for (int o = operators; o < count; o++) {
      if (entersGoalZone(o)) {
        edge(o);
      }
    }
  }

  /** An operator that costs something and leads into the goal zone, perhaps from within it. */
  private void edge(int o) {
    if (edgeSize == edge.length) {
      edge = Arrays.copyOf(edge, 2 * edgeSize);
    }
    edge[edgeSize++] = o;
  }

  private boolean entersGoalZone(int o) {
    for (int fact : added[o]) {
      if (inGoalZone[fact]) {
        return true;
      }
    }
    return false;
  }

  /** Finds the cut before the goal zone, pays for it, and tells its cost. */
  private long pay() {
    Arrays.fill(inFrontZone, false);
    for (int i = 0; i < initialCount; i++) {
      inFrontZone[initial[i]] = true;
    }
    boolean isFrontWhole = false;
    int cutSize = 0;
    long least = Long.MAX_VALUE;
    for (int i = 0; i < edgeSize; i++) {
      int o = edge[i];
      int from = supporter[o];
      if (taken[o] || inGoalZone[from]) {
        continue;
      }
      if (!inFrontZone[from] && !isFrontWhole && !leadsBackToFront(from)) {
        findFront();
        isFrontWhole = true;
      }
      if (inFrontZone[from]) {
        taken[o] = true;
        edge[cutSize++] = o;
        least = Math.min(least, rest[o]);
      }
    }
    for (int i = 0; i < cutSize; i++) {
      taken[edge[i]] = false;
    }
    queue.clear();
    for (int i = 0; i < cutSize; i++) {
      rest[edge[i]] -= least;
      offer(edge[i], supporterValue[edge[i]] + rest[edge[i]]);
    }
    bringUpToDate();
    return least;
  }

  /**
   * Whether the way on which the fact is reached soonest begins in the front zone and keeps out of
   * the goal zone; then all of it is in the front zone. If not, another way may.
   */
  private boolean leadsBackToFront(int last) {
    int size = 0;
    int fact = last;
    while (!inFrontZone[fact]) {
      int by = reachedBy[fact];
      // Steps that cost nothing may have been found to lead to each other in a circle.
      if (size == stack.length || inGoalZone[fact] || entersGoalZone(by)) {
        return false;
      }
      stack[size++] = fact;
      fact = supporter[by];
    }
    while (size > 0) {
      inFrontZone[stack[--size]] = true;
    }
    return true;
  }

  /** All that can be reached without the goal zone. */
  private void findFront() {
    int size = 0;
    for (int i = 0; i < initialCount; i++) {
      stack[size++] = initial[i];
    }
    Arrays.fill(inFrontZone, false);
    for (int i = 0; i < size; i++) {
      inFrontZone[stack[i]] = true;
    }
    while (size > 0) {
      int fact = stack[--size];
      for (int o : consumers[fact]) {
        size = enter(o, fact, size);
      }
      for (int o = operators; fact == truth && o < count; o++) {
        size = enter(o, fact, size);
      }
    }
  }

  private int enter(int o, int fact, int before) {
    int size = before;
    if (supporter[o] == fact && !entersGoalZone(o)) {
      for (int next : added[o]) {
        if (!inFrontZone[next]) {
          inFrontZone[next] = true;
          stack[size++] = next;
        }
      }
    }
    return size;
  }

  private void bringUpToDate() {
    while (!queue.isEmpty()) {
      long now = queue.leastKey();
      int fact = queue.removeLeast();
      if (now > value[fact]) {
        continue;
      }
      patience.check();
      for (int o : consumers[fact]) {
        if (supporter[o] == fact && supporterValue[o] > now) {
          long before = supporterValue[o];
          chooseSupporter(o);
          if (supporterValue[o] < before) {
            offer(o, supporterValue[o] + rest[o]);
          }
        }
      }
    }
  }

  private void chooseSupporter(int o) {
    int dearest = needed[o][0];
    for (int fact : needed[o]) {
      if (value[fact] > value[dearest]) {
        dearest = fact;
      }
    }
    supporter[o] = dearest;
    supporterValue[o] = value[dearest];
  }
}
