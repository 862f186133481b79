package org.maestro.planning.ground;

import java.util.Arrays;

/**
 * A predicate or function of terms: an object's number, or the n-th parameter as {@code -1 - n}.
 *
 * @param symbol the predicate's or function's number
 */
public record Atom(int symbol, int[] terms) {
  /** The term of the n-th parameter. */
  public static int parameter(int n) {
    return -1 - n;
  }

  /** Whether a term is a parameter. */
  public static boolean isParameter(int term) {
    return term < 0;
  }

  /** Which parameter a term is. */
  public static int parameterOf(int term) {
    return -1 - term;
  }

  int[] ground(int[] binding) {
    int[] objects = new int[terms.length];
    for (int i = 0; i < objects.length; i++) {
      objects[i] = value(terms[i], binding);
    }
    return objects;
  }

  static int value(int term, int[] binding) {
    return term >= 0 ? term : binding[-1 - term];
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Atom that && symbol == that.symbol && Arrays.equals(terms, that.terms);
  }

  @Override
  public int hashCode() {
    return 31 * symbol + Arrays.hashCode(terms);
  }
}
