package org.maestro.planning.problem;

import org.maestro.sl.Expression;

/** A ground numeric fluent that some feature may change. */
public final class NumberVariable {
  private final Expression.Fluent fluent;
  private double initial;
  private int index = -1;

  NumberVariable(Expression.Fluent fluent, double initial) {
    this.fluent = fluent;
    this.initial = initial;
  }

  public Expression.Fluent fluent() {
    return fluent;
  }

  /** The number given by the facts, or {@link Quantity#UNKNOWN}. */
  public double initial() {
    return initial;
  }

  /** The facts have changed. */
  void renew(double number) {
    initial = number;
  }

  public int index() {
    return index;
  }

  void placeAt(int stateIndex) {
    index = stateIndex;
  }
}
