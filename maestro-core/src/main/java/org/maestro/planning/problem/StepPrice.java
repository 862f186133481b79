package org.maestro.planning.problem;

/**
 * The action cost of an operator in a state, and its duration.
 *
 * @param exact the member itself has given or stated the price
 */
public record StepPrice(NumberExpression cost, NumberExpression seconds, boolean exact) {

  /** In cost units; NaN or infinite when it cannot be said, and then the step may not be taken. */
  public double cost(NumberVector numbers) {
    double stated = cost.value(numbers);
    return stated < 0 ? Double.NaN : stated;
  }

  /** Zero when it cannot be said. */
  public double seconds(NumberVector numbers) {
    double stated = seconds.value(numbers);
    return Double.isFinite(stated) ? stated : 0;
  }
}
