package org.maestro.planning;

import java.util.List;

/** That a variable has a value no longer. */
record End(Variable variable, int value) {

  /** Whether the operator may bring it about: it has the value before the step, and not after. */
  boolean isReachedBy(Operator operator) {
    return mayFollow(operator.precondition().conjuncts())
        && operator.changes().stream().anyMatch(this::isReachedBy);
  }

  private boolean isReachedBy(Change change) {
    return change instanceof Change.OfVariable of
        && of.variable() == variable
        && (change instanceof Change.Put
            ? of.value() != value
            : change instanceof Change.Remove && of.value() == value);
  }

  /** Whether the variable may have the value when all this holds. */
  boolean mayFollow(List<? extends Condition> conditions) {
    return conditions.stream()
        .noneMatch(
            part ->
                part instanceof Condition.Literal literal
                    && literal.variable() == variable
                    && literal.question() == Condition.Question.IS
                    && literal.value() != value);
  }
}
