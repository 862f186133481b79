package org.maestro.planning.sensing;

import java.util.Arrays;
import java.util.Comparator;
import java.util.stream.IntStream;

/**
 * The expected cost of looking into one box after another until the thing is found. For boxes that
 * do not depend on each other the best order is by chance over cost of the look, the same wherever
 * it begins; where a look makes others cheaper or dearer (a robot has come nearer, a lamp shines
 * into two rooms), all orders are weighed against each other while they are few.
 *
 * <p>The chances sum up to 1: what no box holds is no part of the decision.
 */
final class SearchOrder {
  /** Up to so many boxes all orders are weighed: 2 to the power of it sums. */
  private static final int MOST_WEIGHED = 10;

  /**
   * The cost of a box: of the look into it, and of what follows when the thing is there.
   *
   * @param look cost of the look into it
   * @param rest cost of the rest of the plan once the thing is found there
   */
  record Cost(double look, double rest) {}

  private final double[] chance;
  private final Cost[] first;
  private final Cost[][] next;
  private final double[][] known;

  /** All boxes in the best order, where they do not depend on each other; else none. */
  private final int[] order;

  /** For boxes that cost the same whatever was looked into before. */
  SearchOrder(double[] chance, Cost[] cost) {
    this.chance = chance;
    this.first = cost;
    this.next = new Cost[chance.length][];
    Arrays.fill(next, cost);
    this.known = new double[0][];
    // Stable: of equally good ones the first comes first.
    this.order =
        IntStream.range(0, chance.length)
            .boxed()
            .sorted(Comparator.comparingDouble(box -> -chance[box] / cost[box].look()))
            .mapToInt(box -> box)
            .toArray();
  }

  /**
   * @param chance of each box
   * @param first what each box costs when it is the first
   * @param next what a box (second index) costs right after another one (first index) was in vain
   */
  SearchOrder(double[] chance, Cost[] first, Cost[][] next) {
    this.chance = chance;
    this.first = first;
    this.next = next;
    this.known =
        chance.length <= MOST_WEIGHED
            ? new double[chance.length][1 << chance.length]
            : new double[0][];
    this.order = new int[0];
    Arrays.stream(known).forEach(row -> Arrays.fill(row, Double.NaN));
  }

  /** When the search begins with this box and goes on in the best order. */
  double expectedCost(int box) {
    boolean[] open = new boolean[chance.length];
    Arrays.fill(open, true);
    return from(box, first[box], open, 1);
  }

  /** The cost of the look, and of what comes after it. */
  private double from(int box, Cost cost, boolean[] open, double left) {
    double found = Math.min(1, chance[box] / left);
    open[box] = false;
    double missed = found < 1 ? (1 - found) * after(box, open, left - chance[box]) : 0;
    open[box] = true;
    return cost.look() + found * cost.rest() + missed;
  }

  private double after(int box, boolean[] open, double left) {
    return known.length > 0
        ? weighed(box, open, left)
        : order.length > 0 ? inOrder(open, left) : greedy(box, open, left);
  }

  private double weighed(int last, boolean[] open, double left) {
    int key = key(open);
    if (Double.isNaN(known[last][key])) {
      double least = Double.POSITIVE_INFINITY;
      for (int box = 0; box < chance.length; box++) {
        if (open[box]) {
          least = Math.min(least, from(box, next[last][box], open, left));
        }
      }
      known[last][key] = least < Double.POSITIVE_INFINITY ? least : 0;
    }
    return known[last][key];
  }

  private static int key(boolean[] open) {
    int key = 0;
    for (int i = 0; i < open.length; i++) {
      key |= open[i] ? 1 << i : 0;
    }
    return key;
  }

  private double inOrder(boolean[] open, double left) {
    double total = 0;
    double remaining = left;
    for (int box : order) {
      if (open[box]) {
        total += remaining * first[box].look() + chance[box] * first[box].rest();
        remaining -= chance[box];
      }
    }
    return left > 0 ? total / left : 0;
  }

  /** Always the box with the greatest chance for the cost of the look. */
  private double greedy(int from, boolean[] open, double left) {
    boolean[] rest = open.clone();
    double total = 0;
    double remaining = left;
    int last = from;
    for (int box = best(last, rest); box >= 0; box = best(last, rest)) {
      total += remaining * next[last][box].look() + chance[box] * next[last][box].rest();
      remaining -= chance[box];
      rest[box] = false;
      last = box;
    }
    return left > 0 ? total / left : 0;
  }

  private int best(int last, boolean[] open) {
    int best = -1;
    for (int box = 0; box < chance.length; box++) {
      if (open[box]
          && (best < 0
              || chance[box] * next[last][best].look() > chance[best] * next[last][box].look())) {
        best = box;
      }
    }
    return best;
  }
}
