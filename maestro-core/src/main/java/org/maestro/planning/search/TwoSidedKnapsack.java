package org.maestro.planning.search;

import java.util.ArrayDeque;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.maestro.planning.ground.GroundingBudget;

/**
 * One option of each group, such that the sum of gains lies between two values at the least cost:
 * exact, as both halves of the groups are combined in full and then met by a sliding window. Some
 * 40 groups of two options are settled within a second.
 */
public final class TwoSidedKnapsack {
  private static final int MOST_COMBINATIONS = 1 << 21;

  private TwoSidedKnapsack() {}

  /** A gain that a group may give, and what it costs, at least 0. */
  public record Option(long gain, long cost) {}

  /**
   * The best selection of options.
   *
   * @param options of each group the number of the chosen one
   */
  public record Choice(long cost, int[] options) {}

  /** Whether so many options are not too many. */
  public static boolean isSmallEnough(List<List<Option>> groups) {
    int middle = middle(groups);
    return combinations(groups.subList(0, middle)) <= MOST_COMBINATIONS
        && combinations(groups.subList(middle, groups.size())) <= MOST_COMBINATIONS;
  }

  /**
   * The cheapest choice with a sum of gains between two values, both included; empty when there is
   * none.
   *
   * @throws IllegalArgumentException when there are too many options
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  public static Optional<Choice> solve(
      List<List<Option>> groups, long least, long most, GroundingBudget patience) {
    if (!isSmallEnough(groups)) {
      throw new IllegalArgumentException("There are too many options for an exact answer.");
    }
    int middle = middle(groups);
    List<List<Option>> left = groups.subList(0, middle);
    List<List<Option>> right = groups.subList(middle, groups.size());
    Half a = Half.of(left, patience);
    Half b = Half.of(right, patience);
    // As the left sums rise, the window of right sums falls; its cheapest stands first in the
    // queue.
    Deque<Integer> window = new ArrayDeque<>();
    int next = b.gains.length - 1;
    long best = Long.MAX_VALUE;
    int bestLeft = -1;
    int bestRight = -1;
    for (int i = 0; i < a.gains.length; i++) {
      patience.check();
      while (next >= 0 && atLeast(a.gains[i], b.gains[next], least)) {
        while (!window.isEmpty() && b.costs[window.getLast()] > b.costs[next]) {
          window.removeLast();
        }
        window.addLast(next--);
      }
      while (!window.isEmpty() && !atMost(a.gains[i], b.gains[window.getFirst()], most)) {
        window.removeFirst();
      }
      if (!window.isEmpty() && a.costs[i] + b.costs[window.getFirst()] < best) {
        best = a.costs[i] + b.costs[window.getFirst()];
        bestLeft = a.codes[i];
        bestRight = b.codes[window.getFirst()];
      }
    }
    if (bestLeft < 0) {
      return Optional.empty();
    }
    int[] options =
        IntStream.concat(
                Arrays.stream(options(left, bestLeft)), Arrays.stream(options(right, bestRight)))
            .toArray();
    return Optional.of(new Choice(best, options));
  }

  private static boolean atLeast(long a, long b, long least) {
    return least == Long.MIN_VALUE || a + b >= least;
  }

  private static boolean atMost(long a, long b, long most) {
    return most == Long.MAX_VALUE || a + b <= most;
  }

  private static int middle(List<List<Option>> groups) {
    double all = groups.stream().mapToDouble(group -> Math.log(group.size())).sum();
    double sum = 0;
    int middle = 0;
    while (middle < groups.size() && sum < all / 2) {
      sum += Math.log(groups.get(middle++).size());
    }
    return middle;
  }

  private static double combinations(List<List<Option>> groups) {
    return groups.stream().mapToDouble(List::size).reduce(1, (x, y) -> x * y);
  }

  /** The options that a code stands for. */
  private static int[] options(List<List<Option>> groups, int code) {
    int[] options = new int[groups.size()];
    int rest = code;
    for (int i = groups.size() - 1; i >= 0; i--) {
      options[i] = rest % groups.get(i).size();
      rest /= groups.get(i).size();
    }
    return options;
  }

  /** All combinations of some groups, by ascending gain; of equal gains only the cheapest. */
  private record Half(long[] gains, long[] costs, int[] codes) {
    private static Half of(List<List<Option>> groups, GroundingBudget patience) {
      Half all = new Half(new long[] {0}, new long[] {0}, new int[] {0});
      for (List<Option> group : groups) {
        Half extended = new Half(new long[0], new long[0], new int[0]);
        for (int option = 0; option < group.size(); option++) {
          extended = extended.merged(all.with(group.get(option), option, group.size()), patience);
        }
        all = extended;
      }
      return all;
    }

    private Half with(Option option, int number, int options) {
      return new Half(
          Arrays.stream(gains).map(gain -> gain + option.gain()).toArray(),
          Arrays.stream(costs).map(cost -> cost + option.cost()).toArray(),
          Arrays.stream(codes).map(code -> code * options + number).toArray());
    }

    private Half merged(Half other, GroundingBudget patience) {
      int most = gains.length + other.gains.length;
      Half into = new Half(new long[most], new long[most], new int[most]);
      int size = 0;
      int here = 0;
      int there = 0;
      while (here < gains.length || there < other.gains.length) {
        patience.check();
        boolean mine =
            there == other.gains.length || here < gains.length && gains[here] <= other.gains[there];
        Half from = mine ? this : other;
        int at = mine ? here++ : there++;
        if (size == 0 || into.gains[size - 1] != from.gains[at]) {
          into.put(size++, from, at);
        } else if (from.costs[at] < into.costs[size - 1]) {
          into.put(size - 1, from, at);
        }
      }
      return new Half(
          Arrays.copyOf(into.gains, size),
          Arrays.copyOf(into.costs, size),
          Arrays.copyOf(into.codes, size));
    }

    private void put(int at, Half from, int number) {
      gains[at] = from.gains[number];
      costs[at] = from.costs[number];
      codes[at] = from.codes[number];
    }
  }
}
