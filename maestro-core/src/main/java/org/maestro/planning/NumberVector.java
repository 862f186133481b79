package org.maestro.planning;

import java.util.Arrays;

/** The numbers of a state, by index of their variables. Immutable, shared between states. */
final class NumberVector {
  private final double[] values;
  private final int hash;

  NumberVector(double[] values) {
    this.values = values;
    this.hash = Arrays.hashCode(values);
  }

  double get(int index) {
    return values[index];
  }

  double[] copy() {
    return values.clone();
  }

  NumberVector with(int index, double value) {
    double[] changed = copy();
    changed[index] = value;
    return new NumberVector(changed);
  }

  @Override
  public boolean equals(Object other) {
    return this == other
        || other instanceof NumberVector that
            && hash == that.hash
            && Arrays.equals(values, that.values);
  }

  @Override
  public int hashCode() {
    return hash;
  }
}
