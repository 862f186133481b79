package org.maestro.planning.explanation;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Extent;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Condition.Question;
import org.maestro.planning.problem.FixedObstacle;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Quantity;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.settings.SettingAnalysis;
import org.maestro.planning.settings.SettingSum;
import org.maestro.planning.settings.Threshold;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Says of a ground condition that cannot be met what would be needed and what is possible. */
public final class ObstacleText {
  private ObstacleText() {}

  /**
   * @param problem what can be done, the latest that was made
   * @param settings of that problem
   * @param moved what can be changed at all
   */
  static Obstacle obstacle(
      Condition leaf, GroundProblem problem, SettingAnalysis settings, Set<Object> moved) {
    if (leaf instanceof Condition.Literal literal) {
      return ofLiteral(literal, literal.variable().initialCode());
    } else if (leaf instanceof Condition.Compare compare) {
      return ofComparison(compare, problem.initial().numbers(), settings, moved);
    } else if (leaf instanceof Condition.NumberKnown number) {
      Formula unknown = new Formula.UnknownNumber(number.variable().fluent());
      Formula condition = number.known() ? new Formula.Not(unknown) : unknown;
      return FixedObstacle.stated(
          number.known() ? Kind.UNKNOWN : Kind.FACT,
          SlPrinter.print(condition),
          "true",
          number.known() ? "unknown" : "known");
    }
    return ((Condition.Fixed) leaf).obstacle();
  }

  private static Obstacle ofLiteral(Condition.Literal literal, int code) {
    Variable variable = literal.variable();
    Formula.Atom atom = variable.atom(literal.value());
    if (literal.question() == Question.IS_NOT) {
      return FixedObstacle.stated(
          Kind.FACT, SlPrinter.print(new Formula.Not(atom)), "false", "true");
    }
    String condition = SlPrinter.print(atom);
    if (code >= 0) {
      return FixedObstacle.stated(
          Kind.FACT, condition, "true", SlPrinter.print(variable.atom(code)));
    } else if (!variable.observable()) {
      return FixedObstacle.stated(Kind.FACT, condition, "true", "false");
    } else if (variable.isUnknown(code, literal.value())) {
      return FixedObstacle.stated(Kind.UNKNOWN, condition, "true", "unknown");
    } else if (!variable.functional()) {
      return FixedObstacle.stated(Kind.FACT, condition, "true", "false");
    }
    return FixedObstacle.stated(
        Kind.EXCLUDED,
        condition,
        "true",
        variable.excluded(code).stream().map(SlPrinter::print).collect(Collectors.joining(" ")));
  }

  private static Obstacle ofComparison(
      Condition.Compare compare,
      NumberVector numbers,
      SettingAnalysis settings,
      Set<Object> moved) {
    Formula formula =
        new Formula.Comparison(
            compare.relation(), expression(compare.left()), expression(compare.right()));
    String condition = SlPrinter.print(compare.positive() ? formula : new Formula.Not(formula));
    return Threshold.of(compare)
        .map(threshold -> ofThreshold(threshold, condition, numbers, settings, moved))
        .orElseGet(() -> FixedObstacle.stated(Kind.FACT, condition, "true", "false"));
  }

  private static Obstacle ofThreshold(
      Threshold threshold,
      String condition,
      NumberVector numbers,
      SettingAnalysis settings,
      Set<Object> moved) {
    String needed =
        (threshold.upward() ? ">" : "<")
            + (threshold.strict() ? " " : "= ")
            + SlPrinter.print(threshold.bound());
    double now = threshold.variable().initial();
    if (Quantity.isUnknown(now)) {
      return FixedObstacle.stated(Kind.UNKNOWN, condition, needed, "unknown");
    }
    return new Obstacle(
        Kind.NUMBER,
        condition,
        needed,
        SlPrinter.print(now),
        Extent.KNOWN,
        missing(threshold, numbers, settings, moved),
        Optional.empty(),
        Optional.empty(),
        List.of());
  }

  /** By how much more settings that add up would do; what else is done may depend on more. */
  private static OptionalDouble missing(
      Threshold threshold, NumberVector numbers, SettingAnalysis settings, Set<Object> moved) {
    NumberVariable variable = threshold.variable();
    Optional<SettingSum> sum = settings.sum(variable);
    if (sum.isEmpty() && moved.contains(variable)) {
      return OptionalDouble.empty();
    }
    double best =
        sum.map(all -> all.extreme(numbers, threshold.upward())).orElse(variable.initial());
    double missing = Quantity.rounded(threshold.missing(best));
    return missing > 0 ? OptionalDouble.of(missing) : OptionalDouble.empty();
  }

  /** The goal itself; others than those who can be counted on now might bring it about. */
  public static Obstacle ofGoal(PlanningTask task) {
    boolean others = !task.unavailable().isEmpty() || !task.barred().isEmpty();
    return FixedObstacle.stated(Kind.GOAL, SlPrinter.print(task.goal()), "true", "false")
        .with(others ? Extent.LIMIT_NOW : Extent.LIMIT);
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
