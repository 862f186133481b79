package org.maestro.planning;

import java.util.List;

/** Applies operators to states. What is on the right of a change is read before the step; what is added wins over what is removed. */
final class Successors {
  private Successors() {}

  static boolean isApplicable(Operator operator, State state) {
    return operator.precondition().holds(state)
        && Double.isFinite(operator.price().cost(state.numbers()));
  }

  /** The state after the operator; the same object when nothing changes. */
  static State after(Operator operator, State state) {
    int[] codes = null;
    double[] numbers = null;
    List<Change> changes = operator.changes();
    for (int i = 0; i < changes.size(); i++) {
      Change change = changes.get(i);
      if (change instanceof Change.Remove remove && remove.condition().holds(state)) {
        codes = codes == null ? state.copyOfCodes() : codes;
        int at = remove.variable().index();
        codes[at] = remove.variable().without(codes[at], remove.value());
      }
    }
    for (int i = 0; i < changes.size(); i++) {
      Change change = changes.get(i);
      if (change instanceof Change.OfNumber ofNumber) {
        if (ofNumber.condition().holds(state)) {
          numbers = numbers == null ? state.numbers().copy() : numbers;
          int at = ofNumber.variable().index();
          numbers[at] = changed(ofNumber, numbers[at], state.numbers());
        }
      } else if (!(change instanceof Change.Remove) && change.condition().holds(state)) {
        Change.OfVariable added = (Change.OfVariable) change;
        if (change instanceof Change.Put
            || added.variable().isUnknown(state.code(added.variable()), added.value())) {
          codes = codes == null ? state.copyOfCodes() : codes;
          codes[added.variable().index()] = added.value();
        }
      }
    }
    if (codes == null && numbers == null) {
      return state;
    }
    State after =
        new State(
            codes == null ? state.copyOfCodes() : codes,
            numbers == null ? state.numbers() : new NumberVector(numbers));
    return after.equals(state) ? state : after;
  }

  private static double changed(Change.OfNumber change, double now, NumberVector before) {
    if (!(change instanceof Change.Adjust adjust)) {
      return Quantity.isUnknown(now) ? Quantity.ANY : now;
    }
    double value = adjust.value().value(before);
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
