package org.maestro.planning.problem;

import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * Applies operators to states. What is on the right of a change is read before the step; what is
 * added wins over what is removed, and what is removed twice is removed once.
 */
public final class Successors {
  private Successors() {}

  public static boolean isApplicable(Operator operator, State state) {
    return operator.precondition().holds(state)
        && Double.isFinite(operator.price().cost(state.numbers()));
  }

  /** The state after the operator; the same object when nothing changes. */
  public static State after(Operator operator, State state) {
    int[] codes = null;
    List<Change> changes = operator.changes();
    for (int i = 0; i < changes.size(); i++) {
      Change change = changes.get(i);
      if (change instanceof Change.Remove remove && remove.condition().holds(state)) {
        codes = codes == null ? state.copyOfCodes() : codes;
        int at = remove.variable().index();
        boolean isRemovedAlready =
            state.code(remove.variable()) == remove.value() && codes[at] != remove.value();
        if (!isRemovedAlready) {
          codes[at] = remove.variable().without(codes[at], remove.value());
        }
      }
    }
    for (int i = 0; i < changes.size(); i++) {
      Change change = changes.get(i);
      if (change instanceof Change.OfVariable added
          && !(change instanceof Change.Remove)
          && change.condition().holds(state)
          && (change instanceof Change.Put
              || added.variable().isUnknown(state.code(added.variable()), added.value()))) {
        codes = codes == null ? state.copyOfCodes() : codes;
        codes[added.variable().index()] = added.value();
      }
    }
    double[] numbers = numbersAfter(changes, state);
    if (codes == null && numbers == null) {
      return state;
    }
    State after =
        new State(
            codes == null ? state.copyOfCodes() : codes,
            numbers == null ? state.numbers() : new NumberVector(numbers));
    return after.equals(state) ? state : after;
  }

  /**
   * Null when no number changes. What is unknown before the step is "any" after it if measured,
   * whatever else is done to it.
   */
  private static double @Nullable [] numbersAfter(List<Change> changes, State state) {
    double[] numbers = null;
    for (int i = 0; i < changes.size(); i++) {
      Change change = changes.get(i);
      if (change instanceof Change.Adjust adjust && adjust.condition().holds(state)) {
        numbers = numbers == null ? state.numbers().copy() : numbers;
        int at = adjust.variable().index();
        numbers[at] = adjusted(adjust, numbers[at], adjust.value().value(state.numbers()));
      }
    }
    for (int i = 0; i < changes.size(); i++) {
      if (changes.get(i) instanceof Change.Measure measure
          && Quantity.isUnknown(state.number(measure.variable()))
          && measure.condition().holds(state)) {
        numbers = numbers == null ? state.numbers().copy() : numbers;
        int at = measure.variable().index();
        numbers[at] = Quantity.isUnknown(numbers[at]) ? Quantity.ANY : numbers[at];
      }
    }
    return numbers;
  }

  /** What a number is after changes of its own that all happen, from these numbers before. */
  public static double after(List<Change> own, NumberVector before, NumberVariable variable) {
    double number = before.get(variable.index());
    boolean unknown = Quantity.isUnknown(number);
    for (Change change : own) {
      if (change instanceof Change.Adjust adjust) {
        number = adjusted(adjust, number, adjust.value().value(before));
      }
    }
    boolean measured = own.stream().anyMatch(Change.Measure.class::isInstance);
    return unknown && measured && Quantity.isUnknown(number) ? Quantity.ANY : number;
  }

  static double adjusted(Change.Adjust adjust, double now, double value) {
    return switch (adjust.assignment()) {
      case ASSIGN -> Quantity.rounded(value);
      case INCREASE -> sum(now, value);
      case DECREASE -> sum(now, -value);
    };
  }

  private static double sum(double now, double added) {
    if (Quantity.isUnknown(now) || Quantity.isUnknown(added)) {
      return Quantity.UNKNOWN;
    }
    return Double.isInfinite(now) || Double.isInfinite(added)
        ? Quantity.ANY
        : Quantity.rounded(now + added);
  }
}
