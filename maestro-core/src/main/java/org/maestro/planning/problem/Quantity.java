package org.maestro.planning.problem;

/**
 * The two numbers that are none: unknown, and "any" (to be measured by an earlier step; every
 * comparison with it holds). Known numbers are kept to a millionth, so that sums do not depend on
 * the order of their parts.
 */
public final class Quantity {
  public static final double UNKNOWN = Double.NaN;
  public static final double ANY = Double.POSITIVE_INFINITY;

  private static final double GRAIN = 1e6;
  private static final double TOLERANCE = 1e-9;

  private Quantity() {}

  public static boolean isUnknown(double value) {
    return Double.isNaN(value);
  }

  public static boolean isAny(double value) {
    return value == ANY;
  }

  public static double rounded(double value) {
    return Math.abs(value) < Long.MAX_VALUE / GRAIN
        ? Math.rint(value * GRAIN) / GRAIN + 0.0
        : value;
  }

  /** At least so much, but for rounding. */
  public static boolean atLeast(double left, double right) {
    return left >= right - TOLERANCE;
  }

  /** More than rounding makes of it. */
  public static boolean greater(double left, double right) {
    return left > right + TOLERANCE;
  }
}
