package org.maestro.planning;

import java.util.List;
import java.util.stream.Collectors;
import org.maestro.planning.Condition.Question;
import org.maestro.planning.PlanningResult.Obstacle;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Words a ground condition that cannot be met, with what would be needed and what is possible. */
final class ObstacleText {
  private static final String NOBODY = "no agent can change it";

  private ObstacleText() {}

  static Obstacle obstacle(
      Condition leaf, State initial, SettingAnalysis settings, String neededBy) {
    if (leaf instanceof Condition.Literal literal) {
      return ofLiteral(literal, initial.code(literal.variable()), neededBy);
    } else if (leaf instanceof Condition.Compare compare) {
      return ofComparison(compare, initial.numbers(), settings, neededBy);
    } else if (leaf instanceof Condition.NumberKnown number) {
      Formula unknown = new Formula.UnknownNumber(number.variable().fluent());
      Formula condition = number.known() ? new Formula.Not(unknown) : unknown;
      return new Obstacle(
          SlPrinter.print(condition), number.known() ? "known" : "unknown", NOBODY, neededBy);
    }
    Condition.Fixed fixed = (Condition.Fixed) leaf;
    return new Obstacle(fixed.condition(), fixed.needed(), fixed.possible(), neededBy);
  }

  private static Obstacle ofLiteral(Condition.Literal literal, int code, String neededBy) {
    Variable variable = literal.variable();
    Formula.Atom atom = variable.atom(literal.value());
    boolean negative = literal.question() == Question.IS_NOT;
    Formula condition = negative ? new Formula.Not(atom) : atom;
    return new Obstacle(
        SlPrinter.print(condition),
        negative ? "false" : "true",
        possible(variable, literal.value(), code),
        neededBy);
  }

  private static String possible(Variable variable, int value, int code) {
    if (code >= 0) {
      return "known: " + SlPrinter.print(variable.atom(code)) + "; " + NOBODY;
    } else if (!variable.observable()) {
      return NOBODY;
    } else if (variable.isUnknown(code, value)) {
      return "unknown; no agent can find it out";
    } else if (!variable.functional()) {
      return "known false; " + NOBODY;
    }
    return variable.excluded(code).stream()
        .map(SlPrinter::print)
        .collect(Collectors.joining(", ", "looked in ", "; excluded"));
  }

  private static Obstacle ofComparison(
      Condition.Compare compare, NumberVector numbers, SettingAnalysis settings, String neededBy) {
    Formula formula =
        new Formula.Comparison(
            compare.relation(), expression(compare.left()), expression(compare.right()));
    String condition = SlPrinter.print(compare.positive() ? formula : new Formula.Not(formula));
    Threshold threshold = Threshold.of(compare);
    if (threshold == null) {
      return new Obstacle(condition, "true", NOBODY, neededBy);
    }
    String relation = (threshold.upward() ? ">" : "<") + (threshold.strict() ? " " : "= ");
    double now = numbers.get(threshold.variable().index());
    SettingSum sum = settings.sum(threshold.variable());
    String possible;
    if (Quantity.isUnknown(now)) {
      possible = "unknown; no agent can measure it";
    } else if (sum != null) {
      possible = SlPrinter.print(sum.extreme(numbers, threshold.upward()));
    } else {
      possible = SlPrinter.print(now);
    }
    return new Obstacle(
        condition, relation + SlPrinter.print(threshold.bound()), possible, neededBy);
  }

  private static Expression expression(NumberExpression number) {
    if (number instanceof NumberExpression.Read read) {
      return read.variable().fluent();
    } else if (number instanceof NumberExpression.Operation operation) {
      List<Expression> operands =
          operation.operands().stream().map(ObstacleText::expression).toList();
      return new Expression.Arithmetic(operation.operator(), operands);
    }
    return new Expression.OfTerm(new Term.Number(((NumberExpression.Constant) number).number()));
  }
}
