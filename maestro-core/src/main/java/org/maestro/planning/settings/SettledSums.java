package org.maestro.planning.settings;

import java.util.Collection;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Quantity;
import org.maestro.planning.problem.State;

/**
 * Gives the sums of settings the value that follows from the settings alone, however they came to
 * be as they are. What is added step by step is rounded at each step, so that else the same
 * settings would be as many states as there are ways to them. Immutable.
 */
public final class SettledSums {
  private final Collection<SettingSum> sums;
  private final NumberVector initial;

  public SettledSums(SettingAnalysis settings, NumberVector initial) {
    this.sums = settings.sums().values();
    this.initial = initial;
  }

  /** The same state when there is nothing to settle. */
  public State settled(State state) {
    double[] numbers = null;
    for (SettingSum sum : sums) {
      int at = sum.variable().index();
      double now = state.numbers().get(at);
      if (Double.isFinite(now) && Double.isFinite(initial.get(at))) {
        double value = value(sum, state.numbers());
        if (value != now) {
          numbers = numbers == null ? state.numbers().copy() : numbers;
          numbers[at] = value;
        }
      }
    }
    return numbers == null ? state : new State(state.copyOfCodes(), new NumberVector(numbers));
  }

  private double value(SettingSum sum, NumberVector numbers) {
    double value = initial.get(sum.variable().index());
    for (SettingSum.Part part : sum.parts()) {
      int at = part.setting().variable().index();
      value += part.factor() * (numbers.get(at) - initial.get(at));
    }
    return Quantity.rounded(value);
  }
}
