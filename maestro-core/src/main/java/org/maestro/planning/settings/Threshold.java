package org.maestro.planning.settings;

import java.util.Optional;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Quantity;
import org.maestro.sl.Formula.Relation;

/**
 * A comparison of one number with a constant, seen as a bound to be reached.
 *
 * @param upward whether the number has to be raised to it
 */
public record Threshold(NumberVariable variable, boolean upward, double bound, boolean strict) {

  /** The threshold that the comparison is, if it is one. */
  public static Optional<Threshold> of(Condition.Compare compare) {
    if (compare.relation() == Relation.EQUAL) {
      return Optional.empty();
    }
    boolean upward =
        compare.relation() == Relation.AT_LEAST || compare.relation() == Relation.GREATER;
    boolean strict = compare.relation() == Relation.LESS || compare.relation() == Relation.GREATER;
    if (!compare.positive()) {
      upward = !upward;
      strict = !strict;
    }
    if (compare.left() instanceof NumberExpression.Read read
        && compare.right() instanceof NumberExpression.Constant bound) {
      return of(read, upward, bound, strict);
    } else if (compare.right() instanceof NumberExpression.Read read
        && compare.left() instanceof NumberExpression.Constant bound) {
      return of(read, !upward, bound, strict);
    }
    return Optional.empty();
  }

  private static Optional<Threshold> of(
      NumberExpression.Read read, boolean upward, NumberExpression.Constant bound, boolean strict) {
    return Double.isFinite(bound.number())
        ? Optional.of(new Threshold(read.variable(), upward, bound.number(), strict))
        : Optional.empty();
  }

  public boolean isMetBy(double value) {
    double difference = upward ? value - bound : bound - value;
    return strict ? Quantity.greater(difference, 0) : Quantity.atLeast(difference, 0);
  }

  /** How far the value is from the bound. */
  public double missing(double value) {
    return upward ? bound - value : value - bound;
  }
}
