package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundTask.Bound;
import org.maestro.planning.ground.GroundingBudget;

/**
 * A ground task with its facts numbered anew without gaps, in arrays that searches run over. A
 * state is an array of longs: a bit for each fact, then the sums. In the relaxation a bound is a
 * fact after the others, which every operator adds that moves its sum towards it.
 */
final class SearchTask {
  final GroundTask origin;
  final List<GroundOperator> operators;
  final int facts;
  final int words;
  final int[][] needed;
  final int[][] added;
  final int[][] deleted;
  final long[] cost;
  final int[] goal;
  final long[] initial;

  /** With bounds as facts. */
  final int relaxedFacts;

  final int[][] relaxedNeeded;
  final int[][] relaxedAdded;
  final int[] relaxedGoal;
  final int[][] consumers;
  final int[] withoutNeeds;

  private final int[] numberOf;

  /**
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  SearchTask(GroundTask origin, List<GroundOperator> operators, GroundingBudget patience) {
    this.origin = origin;
    this.operators = operators;
    BitSet used = new BitSet(origin.facts());
    Arrays.stream(origin.goal()).forEach(used::set);
    for (GroundOperator operator : operators) {
      patience.check();
      for (int fact : operator.needed()) {
        used.set(fact);
      }
    }
    patience.refuseIfOver();
    numberOf = new int[origin.facts()];
    Arrays.fill(numberOf, -1);
    int count = 0;
    for (int fact = used.nextSetBit(0); fact >= 0; fact = used.nextSetBit(fact + 1)) {
      numberOf[fact] = count++;
    }
    facts = count;
    words = (facts + 63) / 64;
    int size = operators.size();
    needed = new int[size][];
    added = new int[size][];
    deleted = new int[size][];
    cost = new long[size];
    relaxedNeeded = new int[size][];
    relaxedAdded = new int[size][];
    relaxedFacts = facts + origin.bounds().size();
    for (int o = 0; o < size; o++) {
      patience.check();
      GroundOperator operator = operators.get(o);
      needed[o] = renumbered(operator.needed());
      added[o] = renumbered(operator.added());
      deleted[o] = renumbered(operator.deleted());
      cost[o] = operator.cost();
      relaxedNeeded[o] = withBounds(needed[o], operator.bounds());
      relaxedAdded[o] = withBounds(added[o], helped(operator));
    }
    patience.refuseIfOver();
    goal = renumbered(origin.goal());
    relaxedGoal = withBounds(goal, origin.goalBounds());
    initial = new long[words + origin.sums().length];
    for (int fact : renumbered(origin.initial())) {
      set(initial, fact);
    }
    System.arraycopy(origin.sums(), 0, initial, words, origin.sums().length);
    patience.refuseIfOver();
    consumers = inverse(relaxedNeeded, relaxedFacts);
    patience.refuseIfOver();
    List<Integer> free = new ArrayList<>();
    for (int o = 0; o < size; o++) {
      if (relaxedNeeded[o].length == 0) {
        free.add(o);
      }
    }
    withoutNeeds = free.stream().mapToInt(Integer::intValue).toArray();
  }

  private int[] renumbered(int[] list) {
    return Arrays.stream(list).map(fact -> numberOf[fact]).filter(fact -> fact >= 0).toArray();
  }

  private int[] withBounds(int[] list, int[] bounds) {
    if (bounds.length == 0) {
      return list;
    }
    int[] all = Arrays.copyOf(list, list.length + bounds.length);
    for (int i = 0; i < bounds.length; i++) {
      all[list.length + i] = facts + bounds[i];
    }
    return all;
  }

  /** The bounds that an operator may bring nearer. */
  private int[] helped(GroundOperator operator) {
    if (operator.changedSums().length == 0) {
      return new int[0];
    }
    List<Integer> helped = new ArrayList<>();
    for (int b = 0; b < origin.bounds().size(); b++) {
      Bound bound = origin.bounds().get(b);
      for (int i = 0; i < operator.changedSums().length; i++) {
        long change = operator.changes()[i];
        if (operator.changedSums()[i] == bound.sum()
            && change != 0
            && (change > 0 ? bound.least() > Long.MIN_VALUE : bound.most() < Long.MAX_VALUE)) {
          helped.add(b);
        }
      }
    }
    return helped.stream().mapToInt(Integer::intValue).toArray();
  }

  /** For each number the lists that it is in. */
  static int[][] inverse(int[][] lists, int numbers) {
    int[] sizes = new int[numbers];
    for (int[] list : lists) {
      for (int number : list) {
        sizes[number]++;
      }
    }
    int[][] result = new int[numbers][];
    for (int number = 0; number < numbers; number++) {
      result[number] = new int[sizes[number]];
    }
    for (int i = lists.length - 1; i >= 0; i--) {
      for (int number : lists[i]) {
        result[number][--sizes[number]] = i;
      }
    }
    return result;
  }

  static void set(long[] state, int fact) {
    state[fact >> 6] |= 1L << fact;
  }

  static void clear(long[] state, int fact) {
    state[fact >> 6] &= ~(1L << fact);
  }

  static boolean holds(long[] state, int fact) {
    return (state[fact >> 6] >> fact & 1) != 0;
  }

  boolean holdAll(long[] state, int[] list) {
    for (int fact : list) {
      if (!holds(state, fact)) {
        return false;
      }
    }
    return true;
  }

  /** Whether a relaxed fact, which may be a bound, holds. */
  boolean holdsRelaxed(long[] state, int fact) {
    return fact < facts ? holds(state, fact) : keeps(state, fact - facts);
  }

  private boolean keeps(long[] state, int bound) {
    Bound asked = origin.bounds().get(bound);
    return asked.holds(state[words + asked.sum()]);
  }

  /** How far a sum is from its bound, and 0 within. */
  long gap(long[] state, int bound) {
    Bound asked = origin.bounds().get(bound);
    long value = state[words + asked.sum()];
    if (value < asked.least()) {
      return asked.least() - value;
    }
    return value > asked.most() ? value - asked.most() : 0;
  }

  boolean isApplicable(long[] state, int operator) {
    if (!holdAll(state, needed[operator])) {
      return false;
    }
    for (int bound : operators.get(operator).bounds()) {
      if (!keeps(state, bound)) {
        return false;
      }
    }
    return true;
  }

  boolean isGoal(long[] state) {
    if (!holdAll(state, goal)) {
      return false;
    }
    for (int bound : origin.goalBounds()) {
      if (!keeps(state, bound)) {
        return false;
      }
    }
    return true;
  }

  long[] after(long[] state, int operator) {
    long[] after = state.clone();
    for (int fact : deleted[operator]) {
      clear(after, fact);
    }
    for (int fact : added[operator]) {
      set(after, fact);
    }
    GroundOperator ground = operators.get(operator);
    for (int i = 0; i < ground.changedSums().length; i++) {
      after[words + ground.changedSums()[i]] += ground.changes()[i];
    }
    return after;
  }

  /** The relaxed facts of a state. */
  void forEachFact(long[] state, java.util.function.IntConsumer consumer) {
    for (int word = 0; word < words; word++) {
      for (long bits = state[word]; bits != 0; bits &= bits - 1) {
        consumer.accept((word << 6) + Long.numberOfTrailingZeros(bits));
      }
    }
    for (int bound = 0; bound < relaxedFacts - facts; bound++) {
      if (keeps(state, bound)) {
        consumer.accept(facts + bound);
      }
    }
  }
}
