package org.maestro.coordination.worth;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;

/**
 * The ends of goals by their shape, from which it is learned how likely the next of the shape is to
 * be reached: {@code p = (s + 2·p0)/(n + 2)}, of the last n goals that were reached or failed. A
 * goal that was cancelled shows nothing.
 */
final class PastOutcomes {
  private static final int MOST_OF_A_SHAPE = 50;
  private static final int MOST_SHAPES = 1_000;
  private static final int WEIGHT_OF_PRIOR = 2;

  private final Map<String, Past> byShape = new LinkedHashMap<>();

  private static final class Past {
    private final Deque<Boolean> reached = new ArrayDeque<>();
    private double costs;
    private int planned;
  }

  /** Returns whether that changes anything. */
  boolean add(String shape, GoalOutcome outcome) {
    if (outcome.state() != GoalState.ACHIEVED && outcome.state() != GoalState.FAILED) {
      return false;
    }
    Past past = of(shape);
    past.reached.addLast(outcome.reached());
    if (past.reached.size() > MOST_OF_A_SHAPE) {
      past.reached.removeFirst();
    }
    return true;
  }

  /** The cost of a whole plan that was made for a goal of the shape. */
  void planned(String shape, double cost) {
    Past past = of(shape);
    past.costs += cost;
    past.planned++;
  }

  private Past of(String shape) {
    Past past = byShape.remove(shape);
    if (past == null) {
      past = new Past();
    }
    byShape.put(shape, past);
    Iterator<Past> oldest = byShape.values().iterator();
    if (byShape.size() > MOST_SHAPES) {
      oldest.next();
      oldest.remove();
    }
    return past;
  }

  /**
   * @param prior the chance as long as nothing was tried
   */
  double chance(String shape, double prior) {
    Past past = byShape.get(shape);
    if (past == null) {
      return prior;
    }
    long reached = past.reached.stream().filter(Boolean::booleanValue).count();
    return (reached + WEIGHT_OF_PRIOR * prior) / (past.reached.size() + WEIGHT_OF_PRIOR);
  }

  /** How many goals of the shape are remembered. */
  int tried(String shape) {
    Past past = byShape.get(shape);
    return past == null ? 0 : past.reached.size();
  }

  /** The mean of what plans for goals of the shape have cost; 0 when there was none. */
  double meanCost(String shape) {
    Past past = byShape.get(shape);
    return past == null || past.planned == 0 ? 0 : past.costs / past.planned;
  }
}
