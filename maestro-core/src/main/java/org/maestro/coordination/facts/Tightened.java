package org.maestro.coordination.facts;

import java.util.List;
import java.util.function.Predicate;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;

/**
 * A condition with a margin: what is to be at least a number has to be {@value #MARGIN} of it
 * above, what is to be at most one as much below. What was just enough when it was measured with
 * noise is not enough for it, so that settings made by it last.
 */
public final class Tightened {
  /** Five standard deviations of a sensor that errs by 1 %. */
  static final double MARGIN = 0.05;

  private final Predicate<String> isObserved;

  private Tightened(Predicate<String> isObserved) {
    this.isObserved = isObserved;
  }

  /**
   * The tightened condition. Comparisons under a negation, and equalities, stay as they are.
   *
   * @param isObserved which fluents are measured; the other side of the comparison is the limit
   */
  public static Formula of(Formula formula, Predicate<String> isObserved) {
    return new Tightened(isObserved).tightened(formula);
  }

  private Formula tightened(Formula formula) {
    if (formula instanceof Formula.And and) {
      return new Formula.And(and.operands().stream().map(this::tightened).toList());
    } else if (formula instanceof Formula.Or or) {
      return new Formula.Or(or.operands().stream().map(this::tightened).toList());
    } else if (formula instanceof Formula.Exists exists) {
      return new Formula.Exists(exists.variables(), tightened(exists.body()));
    } else if (formula instanceof Formula.Forall forall) {
      return new Formula.Forall(forall.variables(), tightened(forall.body()));
    } else if (formula instanceof Formula.Imply imply) {
      return new Formula.Imply(imply.premise(), tightened(imply.conclusion()));
    } else if (formula instanceof Formula.Comparison comparison
        && comparison.relation() != Formula.Relation.EQUAL) {
      return tightened(comparison);
    }
    return formula;
  }

  private Formula tightened(Formula.Comparison comparison) {
    boolean least =
        comparison.relation() == Formula.Relation.AT_LEAST
            || comparison.relation() == Formula.Relation.GREATER;
    if (isMeasured(comparison.left())) {
      return new Formula.Comparison(
          comparison.relation(), comparison.left(), moved(comparison.right(), least));
    }
    if (isMeasured(comparison.right())) {
      return new Formula.Comparison(
          comparison.relation(), moved(comparison.left(), !least), comparison.right());
    }
    return comparison;
  }

  private boolean isMeasured(Expression expression) {
    boolean[] measured = {false};
    Leaves.of(expression, fluent -> measured[0] |= isObserved.test(fluent.name()));
    return measured[0];
  }

  /** The limit, further up or down by the margin of its amount. */
  private static Expression moved(Expression limit, boolean up) {
    double sign = up ? 1 : -1;
    if (limit instanceof Expression.OfTerm ofTerm && ofTerm.term() instanceof Term.Number number) {
      return number(number.value() + sign * MARGIN * Math.abs(number.value()));
    }
    Expression amount =
        arithmetic(
            Expression.Operator.MAX,
            limit,
            arithmetic(Expression.Operator.MINUS, number(0), limit));
    return arithmetic(
        Expression.Operator.PLUS,
        limit,
        arithmetic(Expression.Operator.TIMES, number(sign * MARGIN), amount));
  }

  private static Expression number(double value) {
    return new Expression.OfTerm(new Term.Number(value));
  }

  private static Expression arithmetic(Expression.Operator operator, Expression... operands) {
    return new Expression.Arithmetic(operator, List.of(operands));
  }
}
