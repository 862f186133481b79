package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * The least cost to gain a needed amount when each group gives at most one of its options. Exact by
 * branch and bound over the fractional bound; after {@link #MOST_NODES} nodes only the fractional
 * bound at the root, which is never above the exact answer.
 */
final class MultipleChoiceKnapsack {
  private static final int MOST_NODES = 3000;
  private static final double TOLERANCE = 1e-9;

  record Option(double gain, double cost) {}

  /** A step along a group's lower convex hull. */
  private record Segment(int group, double gain, double cost) {
    double slope() {
      return cost / gain;
    }
  }

  private final List<List<Option>> groups;
  private final List<Segment> segments = new ArrayList<>();
  private double best = Double.POSITIVE_INFINITY;
  private int nodes;

  private MultipleChoiceKnapsack(List<List<Option>> groups) {
    this.groups = groups;
    for (int group = 0; group < groups.size(); group++) {
      addHull(group);
    }
    segments.sort(Comparator.comparingDouble(Segment::slope));
  }

  /**
   * The least cost, infinite when the options do not suffice.
   *
   * @param groups options with positive gain and finite cost
   * @param needed 0 or less costs nothing
   */
  static double leastCost(List<List<Option>> groups, double needed) {
    if (needed <= TOLERANCE) {
      return 0;
    }
    MultipleChoiceKnapsack knapsack = new MultipleChoiceKnapsack(groups);
    double bound = knapsack.fractional(0, needed);
    if (bound == Double.POSITIVE_INFINITY) {
      return bound;
    }
    knapsack.branch(0, needed, 0);
    return knapsack.nodes > MOST_NODES ? bound : knapsack.best;
  }

  private void addHull(int group) {
    double gain = 0;
    double cost = 0;
    while (true) {
      Option next = null;
      for (Option option : groups.get(group)) {
        if (option.gain() > gain + TOLERANCE
            && (next == null
                || slope(option, gain, cost) < slope(next, gain, cost) - TOLERANCE
                || slope(option, gain, cost) <= slope(next, gain, cost) + TOLERANCE
                    && option.gain() > next.gain())) {
          next = option;
        }
      }
      if (next == null) {
        return;
      }
      segments.add(new Segment(group, next.gain() - gain, Math.max(0, next.cost() - cost)));
      gain = next.gain();
      cost = Math.max(cost, next.cost());
    }
  }

  private static double slope(Option option, double gain, double cost) {
    return (option.cost() - cost) / (option.gain() - gain);
  }

  private double fractional(int firstGroup, double needed) {
    double cost = 0;
    double open = needed;
    for (Segment segment : segments) {
      if (open <= TOLERANCE) {
        return cost;
      }
      if (segment.group() >= firstGroup) {
        double share = Math.min(1, open / segment.gain());
        cost += share * segment.cost();
        open -= share * segment.gain();
      }
    }
    return open <= TOLERANCE ? cost : Double.POSITIVE_INFINITY;
  }

  private void branch(int group, double needed, double cost) {
    if (needed <= TOLERANCE) {
      best = Math.min(best, cost);
      return;
    }
    if (++nodes > MOST_NODES
        || group == groups.size()
        || cost + fractional(group, needed) >= best - TOLERANCE) {
      return;
    }
    for (Option option : groups.get(group)) {
      branch(group + 1, needed - option.gain(), cost + option.cost());
    }
    branch(group + 1, needed, cost);
  }
}
