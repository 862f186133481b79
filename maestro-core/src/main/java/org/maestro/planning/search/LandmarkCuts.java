package org.maestro.planning.search;

import java.util.Arrays;
import org.maestro.planning.ground.Patience;

/**
 * The landmark-cut lower bound (Helmert and Domshlak 2009) over a {@link SearchTask}, with costs in
 * whole units. Sources may be added for each estimate: sets of facts that are had for a price, as
 * states of leaves are. Values are brought up to date after each cut instead of computed anew. Not
 * thread-safe.
 */
final class LandmarkCuts {
  static final long INFINITE = Long.MAX_VALUE / 4;

  private final SearchTask task;
  private final long[] costs;
  private final Patience patience;
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
  private int[] supporter;
  private long[] supporterValue;
  private int count;
  private final boolean[] inGoalZone;
  private final boolean[] inFrontZone;
  private final int[] stack;
  private int[] cut = new int[64];
  private final IntHeap queue = new IntHeap();
  private final int[] initial;
  private int initialCount;

  /**
   * @param costs of the task's operators, perhaps only a part of each
   */
  LandmarkCuts(SearchTask task, long[] costs, Patience patience) {
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
    achievers = SearchTask.inverse(added, facts);
    patience.refuseIfOver();
    value = new long[facts];
    inGoalZone = new boolean[facts];
    inFrontZone = new boolean[facts];
    stack = new int[facts];
    initial = new int[facts];
    resize(operators);
  }

  private void resize(int size) {
    rest = new long[size];
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
    return estimate();
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

  /** The estimate from what was given since {@link #begin}. */
  long estimate() {
    System.arraycopy(costs, 0, rest, 0, costs.length);
    rest[costs.length] = 0;
    initial[initialCount++] = truth;
    computeValues();
    long total = 0;
    while (true) {
      if (value[goal] >= INFINITE) {
        return INFINITE;
      }
      if (value[goal] == 0) {
        return total;
      }
      Arrays.fill(inGoalZone, false);
      Arrays.fill(inFrontZone, false);
      markGoalZone();
      total += pay();
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
        queue.add(reached, fact);
      }
    }
  }

  private void markGoalZone() {
    int size = 0;
    inGoalZone[goal] = true;
    stack[size++] = goal;
    while (size > 0) {
      for (int o : achievers[stack[--size]]) {
        if (open[o] == 0 && rest[o] == 0 && !inGoalZone[supporter[o]]) {
          inGoalZone[supporter[o]] = true;
          stack[size++] = supporter[o];
        }
      }
    }
  }

  /** Finds the cut before the goal zone, pays for it, and tells its cost. */
  private long pay() {
    int size = 0;
    for (int i = 0; i < initialCount; i++) {
      inFrontZone[initial[i]] = true;
      stack[size++] = initial[i];
    }
    int cutSize = 0;
    long least = Long.MAX_VALUE;
    while (size > 0) {
      int fact = stack[--size];
      int[] users = consumers[fact];
      int extra = fact == truth ? count - operators : 0;
      for (int i = 0; i < users.length + extra; i++) {
        int o = i < users.length ? users[i] : operators + i - users.length;
        if (open[o] > 0 || supporter[o] != fact) {
          continue;
        }
        boolean enters = false;
        for (int next : added[o]) {
          enters |= inGoalZone[next];
        }
        if (enters) {
          if (cutSize == cut.length) {
            cut = Arrays.copyOf(cut, 2 * cutSize);
          }
          cut[cutSize++] = o;
          least = Math.min(least, rest[o]);
          continue;
        }
        for (int next : added[o]) {
          if (!inFrontZone[next]) {
            inFrontZone[next] = true;
            stack[size++] = next;
          }
        }
      }
    }
    queue.clear();
    for (int i = 0; i < cutSize; i++) {
      rest[cut[i]] -= least;
      offer(cut[i], supporterValue[cut[i]] + rest[cut[i]]);
    }
    bringUpToDate();
    return least;
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
        if (open[o] == 0 && supporter[o] == fact && supporterValue[o] > now) {
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
