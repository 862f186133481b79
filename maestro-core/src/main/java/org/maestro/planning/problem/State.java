package org.maestro.planning.problem;

import java.util.Arrays;

/** The facts and numbers at one point of a plan: what is true, unknown and how much. Immutable. */
public final class State {
  private final int[] codes;
  private final NumberVector numbers;
  private final int hash;

  public State(int[] codes, NumberVector numbers) {
    this.codes = codes;
    this.numbers = numbers;
    this.hash = 31 * Arrays.hashCode(codes) + numbers.hashCode();
  }

  /** The code of a variable; see {@link Variable}. */
  public int code(Variable variable) {
    return codes[variable.index()];
  }

  public double number(NumberVariable variable) {
    return numbers.get(variable.index());
  }

  public NumberVector numbers() {
    return numbers;
  }

  public int[] copyOfCodes() {
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
