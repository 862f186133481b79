package org.maestro.sl;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;

/**
 * The variables of a formula that stand where a number does, in the order of their first
 * appearance, and what the formula equates each with: {@code (= (level lamp-1) ?n)}.
 */
public final class NumberVariables {
  private final Set<String> found = new LinkedHashSet<>();
  private final Map<String, List<Expression>> equations = new LinkedHashMap<>();

  private NumberVariables() {}

  /** Those that quantifiers bind too, although quantifiers range over individuals only. */
  public static Set<String> of(Formula formula) {
    return Collections.unmodifiableSet(in(formula).found);
  }

  /** By variable, the numbers of which one is its value; none where it is only compared. */
  public static Map<String, List<Expression>> equationsIn(Formula formula) {
    return Collections.unmodifiableMap(in(formula).equations);
  }

  private static NumberVariables in(Formula formula) {
    NumberVariables variables = new NumberVariables();
    variables.visit(formula);
    return variables;
  }

  private void visit(Formula formula) {
    if (formula instanceof Formula.Comparison comparison) {
      visit(comparison);
    }
    formula.parts().forEach(this::visit);
  }

  private void visit(Formula.Comparison comparison) {
    boolean equates = comparison.relation() == Formula.Relation.EQUAL;
    if (!equates || isNumber(comparison.left()) || isNumber(comparison.right())) {
      number(comparison.left());
      number(comparison.right());
    }
    if (equates) {
      equation(comparison.left(), comparison.right());
      equation(comparison.right(), comparison.left());
    }
  }

  private void equation(Expression side, Expression value) {
    if (isNumber(value)
        && side instanceof Expression.OfTerm ofTerm
        && ofTerm.term() instanceof Term.Variable variable) {
      equations.computeIfAbsent(variable.name(), name -> new ArrayList<>()).add(value);
    }
  }

  private void number(Expression expression) {
    if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(this::number);
    } else if (expression instanceof Expression.OfTerm ofTerm
        && ofTerm.term() instanceof Term.Variable variable) {
      found.add(variable.name());
    }
  }

  private static boolean isNumber(Expression expression) {
    return !(expression instanceof Expression.OfTerm ofTerm)
        || ofTerm.term() instanceof Term.Number;
  }
}
