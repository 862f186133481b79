package org.maestro.planning.problem;

import java.util.Arrays;

/** The numbers of a state, by index of their variables. Immutable, shared between states. */
public final class NumberVector {
  private final double[] values;

  /** Looked for in few of many states; 0 until then. */
  private int hash;

  public NumberVector(double[] values) {
    this.values = values;
  }

  public double get(int index) {
    return values[index];
  }

  public double[] copy() {
    return values.clone();
  }

  public NumberVector with(int index, double value) {
    double[] changed = copy();
    changed[index] = value;
    return new NumberVector(changed);
  }

  @Override
  public boolean equals(Object other) {
    return this == other
        || other instanceof NumberVector that
            && hashCode() == that.hashCode()
            && Arrays.equals(values, that.values);
  }

  @Override
  public int hashCode() {
    if (hash == 0) {
      hash = Arrays.hashCode(values);
    }
    return hash;
  }
}
