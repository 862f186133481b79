package org.maestro.planning.problem;

import org.maestro.sl.Effect.Assignment;

/** One ground effect of an operator. It happens only where its condition held before the step. */
public sealed interface Change {

  Condition condition();

  /** The {@link Variable} or {@link NumberVariable} that is changed. */
  Object target();

  /** The value becomes known. */
  record Put(Condition condition, Variable variable, int value) implements OfVariable {}

  /** The value does not hold any more. */
  record Remove(Condition condition, Variable variable, int value) implements OfVariable {}

  /** The value becomes known if it is unknown: the hope of sensing. */
  record Find(Condition condition, Variable variable, int value) implements OfVariable {}

  /** The number becomes "any" if it is unknown. */
  record Measure(Condition condition, NumberVariable variable) implements OfNumber {}

  record Adjust(
      Condition condition, NumberVariable variable, Assignment assignment, NumberExpression value)
      implements OfNumber {}

  /** A change of a state variable. */
  sealed interface OfVariable extends Change permits Put, Remove, Find {
    Variable variable();

    int value();

    @Override
    default Object target() {
      return variable();
    }
  }

  /** A change of a number. */
  sealed interface OfNumber extends Change permits Measure, Adjust {
    NumberVariable variable();

    @Override
    default Object target() {
      return variable();
    }
  }
}
