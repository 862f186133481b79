package org.maestro.planning.ground;

import java.math.BigDecimal;
import java.util.List;

/**
 * A task over whole numbers: facts that hold or do not, sums that operators add constants to, costs
 * in a common unit. Immutable; the arrays are not to be changed.
 *
 * @param facts how many facts there are
 * @param sums the values of sums at first
 * @param bounds what conditions ask of sums
 * @param initial the facts that hold at first, ascending
 * @param goal the facts that have to hold at the end, ascending
 * @param goalBounds the bounds that have to be kept at the end
 * @param unit how many units of cost are 1
 * @param unreachable a condition of the goal that nothing can bring about was found while grounding
 */
public record GroundTask(
    int facts,
    long[] sums,
    List<Bound> bounds,
    List<GroundOperator> operators,
    int[] initial,
    int[] goal,
    int[] goalBounds,
    BigDecimal unit,
    boolean unreachable,
    Names names) {
  public GroundTask {
    bounds = List.copyOf(bounds);
    operators = List.copyOf(operators);
  }

  /** A sum has to lie between two values, both included. */
  public record Bound(int sum, long least, long most) {
    public boolean holds(long value) {
      return value >= least && value <= most;
    }
  }

  /** The names of facts and operators, for people. */
  public interface Names {
    String fact(int fact);

    /** The operator as a plan has it, such as {@code (move a b)}; empty when it is not shown. */
    String operator(GroundOperator operator);
  }

  /** The same task with some of its operators. */
  public GroundTask withOperators(List<GroundOperator> others) {
    return new GroundTask(
        facts, sums, bounds, others, initial, goal, goalBounds, unit, unreachable, names);
  }
}
