package org.maestro.planning.settings;

import java.util.Optional;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.planning.problem.Condition.Literal;
import org.maestro.planning.problem.Condition.Question;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Quantity;
import org.maestro.sl.Effect.Assignment;

/**
 * The test whether a change may make a condition true, and what else must hold for it. Errs on the
 * side of "it may".
 */
public final class Achievement {
  private Achievement() {}

  /** What must hold besides the change's own condition; false when the change can never help. */
  public static Condition requirement(Change change, Condition leaf, SettingAnalysis settings) {
    if (leaf instanceof Literal literal && change instanceof Change.OfVariable ofVariable) {
      return literal.variable() == ofVariable.variable()
          ? ofLiteral(ofVariable, literal)
          : Constant.FALSE;
    } else if (change instanceof Change.OfNumber ofNumber) {
      if (leaf instanceof Condition.NumberKnown known) {
        return known.variable() == ofNumber.variable()
            ? ofKnowledge(ofNumber, known.known(), settings)
            : Constant.FALSE;
      } else if (leaf instanceof Condition.Compare compare && reads(compare, ofNumber.variable())) {
        return change instanceof Change.Measure measure
            ? new Condition.NumberKnown(measure.variable(), false)
            : ofComparison((Change.Adjust) change, compare);
      }
    }
    return Constant.FALSE;
  }

  private static Condition ofLiteral(Change.OfVariable change, Literal literal) {
    boolean same = change.value() == literal.value();
    if (change instanceof Change.Put) {
      return Constant.of(
          switch (literal.question()) {
            case IS -> same;
            case IS_NOT -> !same;
            case UNKNOWN -> false;
            case NOT_UNKNOWN -> true;
          });
    } else if (change instanceof Change.Find) {
      boolean helps =
          literal.question() == Question.IS && same || literal.question() == Question.NOT_UNKNOWN;
      return helps
          ? new Literal(change.variable(), change.value(), Question.UNKNOWN)
          : Constant.FALSE;
    }
    return switch (literal.question()) {
      case IS -> Constant.FALSE;
      case IS_NOT, NOT_UNKNOWN -> Constant.of(same);
      case UNKNOWN ->
          change.variable().functional() && change.variable().observable()
              ? new Literal(change.variable(), change.value(), Question.IS)
              : Constant.FALSE;
    };
  }

  private static Condition ofKnowledge(
      Change.OfNumber change, boolean known, SettingAnalysis settings) {
    if (change instanceof Change.Adjust adjust) {
      return Constant.of(
          known ? adjust.assignment() == Assignment.ASSIGN : mayBeUnknown(adjust, settings));
    }
    return known ? new Condition.NumberKnown(change.variable(), false) : Constant.FALSE;
  }

  private static boolean mayBeUnknown(Change.Adjust adjust, SettingAnalysis settings) {
    if (adjust.value() instanceof NumberExpression.Constant constant) {
      return Quantity.isUnknown(constant.number());
    }
    boolean[] found = new boolean[1];
    adjust.value().forEachVariable(variable -> found[0] |= !settings.isSetting(variable));
    return found[0];
  }

  private static boolean reads(Condition.Compare compare, NumberVariable variable) {
    return !Setting.readsNone(compare.left(), variable)
        || !Setting.readsNone(compare.right(), variable);
  }

  private static Condition ofComparison(Change.Adjust adjust, Condition.Compare compare) {
    Optional<Threshold> threshold = Threshold.of(compare);
    if (threshold.isEmpty()
        || !(adjust.value() instanceof NumberExpression.Constant constant)
        || Quantity.isUnknown(constant.number())) {
      return Constant.TRUE;
    }
    if (adjust.assignment() == Assignment.ASSIGN) {
      return Constant.of(threshold.get().isMetBy(constant.number()));
    }
    boolean raises = adjust.assignment() == Assignment.INCREASE == constant.number() > 0;
    return constant.number() != 0 && raises == threshold.get().upward()
        ? new Condition.NumberKnown(adjust.variable(), true)
        : Constant.FALSE;
  }
}
