package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.TreeMap;
import java.util.function.IntConsumer;
import java.util.stream.IntStream;
import org.maestro.planning.ground.GroundTask.Bound;
import org.maestro.planning.ground.GroundingBudget;

/** The operators of a task that are of no leaf, and what they ask of each leaf. */
final class CentreOperators {
  private final SearchTask task;
  private final int[] numbers;
  private final int[][] needed;
  private final int[][] bounds;

  /** The leaves that an operator needs something of, ascending, and what. */
  private final int[][] asked;

  private final int[][] conditions;
  private final int[][] unlocked;
  private final int[] goalConditions;
  private final int[] goal;
  private final int[] goalBounds;
  private final BitSet facts;
  private final boolean[] ownSums;
  private final int[] ownBounds;

  /**
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  CentreOperators(SearchTask task, Leaf[] leaves, GroundingBudget patience) {
    this.task = task;
    facts = new BitSet();
    facts.set(0, task.facts);
    ownSums = new boolean[task.origin.sums().length];
    Arrays.fill(ownSums, true);
    for (Leaf leaf : leaves) {
      patience.refuseIfOver();
      for (int fact = 0; fact < task.facts; fact++) {
        if (leaf.space.concerns(fact)) {
          facts.clear(fact);
        }
      }
      for (int sum = 0; sum < ownSums.length; sum++) {
        ownSums[sum] &= !leaf.space.concernsSum(sum);
      }
    }
    ownBounds =
        IntStream.range(0, task.origin.bounds().size())
            .filter(b -> ownSums[task.origin.bounds().get(b).sum()])
            .toArray();
    List<Integer> own = new ArrayList<>();
    for (int o = 0; o < task.operators.size(); o++) {
      patience.check();
      if (isOwn(o)) {
        own.add(o);
      }
    }
    numbers = own.stream().mapToInt(i -> i).toArray();
    needed = new int[numbers.length][];
    bounds = new int[numbers.length][];
    asked = new int[numbers.length][];
    conditions = new int[numbers.length][];
    unlocked = new int[numbers.length][];
    for (int i = 0; i < numbers.length; i++) {
      patience.refuseIfOver();
      prepare(i, leaves);
    }
    goal = Arrays.stream(task.goal).filter(facts::get).toArray();
    goalBounds = own(task.origin.goalBounds());
    goalConditions =
        Arrays.stream(leaves)
            .mapToInt(leaf -> leaf.condition(task.goal, task.origin.goalBounds()))
            .toArray();
  }

  private boolean isOwn(int o) {
    return Arrays.stream(task.added[o]).allMatch(facts::get)
        && Arrays.stream(task.deleted[o]).allMatch(facts::get)
        && Arrays.stream(task.operators.get(o).changedSums()).allMatch(sum -> ownSums[sum]);
  }

  private int[] own(int[] someBounds) {
    return Arrays.stream(someBounds)
        .filter(b -> ownSums[task.origin.bounds().get(b).sum()])
        .toArray();
  }

  private void prepare(int i, Leaf[] leaves) {
    int o = numbers[i];
    needed[i] = Arrays.stream(task.needed[o]).filter(facts::get).toArray();
    bounds[i] = own(task.operators.get(o).bounds());
    TreeMap<Integer, Integer> all = new TreeMap<>();
    List<Integer> changed = new ArrayList<>();
    for (int leaf = 0; leaf < leaves.length; leaf++) {
      int condition = leaves[leaf].condition(task.needed[o], task.operators.get(o).bounds());
      if (condition != Leaf.ANYTHING) {
        all.put(leaf, condition);
      }
      int[] gates = leaves[leaf].gates();
      if (IntStream.concat(Arrays.stream(task.added[o]), Arrays.stream(task.deleted[o]))
          .anyMatch(fact -> Arrays.binarySearch(gates, fact) >= 0)) {
        changed.add(leaf);
      }
    }
    asked[i] = all.keySet().stream().mapToInt(k -> k).toArray();
    conditions[i] = all.values().stream().mapToInt(k -> k).toArray();
    unlocked[i] = changed.stream().mapToInt(k -> k).toArray();
  }

  int size() {
    return numbers.length;
  }

  /** The number in the task. */
  int operator(int i) {
    return numbers[i];
  }

  long cost(int i) {
    return task.cost[numbers[i]];
  }

  int[] asked(int i) {
    return asked[i];
  }

  /** What is asked of each of {@link #asked}. */
  int[] conditions(int i) {
    return conditions[i];
  }

  int condition(int i, int leaf) {
    int at = Arrays.binarySearch(asked[i], leaf);
    return at < 0 ? Leaf.ANYTHING : conditions[i][at];
  }

  /** The leaves of which gates open or close. */
  int[] unlocked(int i) {
    return unlocked[i];
  }

  int[] goalConditions() {
    return goalConditions;
  }

  /** The centre's part of a state; the rest is 0. */
  long[] projection(long[] state) {
    long[] projected = new long[state.length];
    for (int fact = facts.nextSetBit(0); fact >= 0; fact = facts.nextSetBit(fact + 1)) {
      if (SearchTask.holds(state, fact)) {
        SearchTask.set(projected, fact);
      }
    }
    for (int sum = 0; sum < ownSums.length; sum++) {
      projected[task.words + sum] = ownSums[sum] ? state[task.words + sum] : 0;
    }
    return projected;
  }

  boolean isApplicable(long[] centre, int i) {
    return task.holdAll(centre, needed[i]) && keepsAll(centre, bounds[i]);
  }

  private boolean keepsAll(long[] centre, int[] someBounds) {
    for (int b : someBounds) {
      Bound bound = task.origin.bounds().get(b);
      if (!bound.holds(centre[task.words + bound.sum()])) {
        return false;
      }
    }
    return true;
  }

  long[] after(long[] centre, int i) {
    return task.after(centre, numbers[i]);
  }

  boolean isGoal(long[] centre) {
    return task.holdAll(centre, goal) && keepsAll(centre, goalBounds);
  }

  /** The relaxed facts of a centre. */
  void forEachFact(long[] centre, IntConsumer consumer) {
    for (int word = 0; word < task.words; word++) {
      for (long bits = centre[word]; bits != 0; bits &= bits - 1) {
        consumer.accept((word << 6) + Long.numberOfTrailingZeros(bits));
      }
    }
    for (int bound : ownBounds) {
      if (keepsAll(centre, new int[] {bound})) {
        consumer.accept(task.facts + bound);
      }
    }
  }
}
