package org.maestro.planning;

import java.util.Arrays;

/** What is true, unknown and how much at one point of a plan. Immutable. */
final class State {
  private final int[] codes;
  private final NumberVector numbers;
  private final int hash;

  State(int[] codes, NumberVector numbers) {
    this.codes = codes;
    this.numbers = numbers;
    this.hash = 31 * Arrays.hashCode(codes) + numbers.hashCode();
  }

  /** The code of a variable; see {@link Variable}. */
  int code(Variable variable) {
    return codes[variable.index()];
  }

  double number(NumberVariable variable) {
    return numbers.get(variable.index());
  }

  NumberVector numbers() {
    return numbers;
  }

  int[] copyOfCodes() {
    return codes.clone();
  }

  @Override
  public boolean equals(Object other) {
    return this == other
        || other instanceof State that
            && hash == that.hash
            && Arrays.equals(codes, that.codes)
            && numbers.equals(that.numbers);
  }

  @Override
  public int hashCode() {
    return hash;
  }
}
