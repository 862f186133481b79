package org.maestro.device.tasks;

import org.maestro.sl.SlPrinter;

/** Numbers as people read them. */
public final class Numbers {

  private static final double TENTHS = 10;
  private static final double THOUSANDTHS = 1000;
  private static final double FULL_CIRCLE = 360;

  private Numbers() {}

  static double tenths(double value) {
    return Math.round(value * TENTHS) / TENTHS;
  }

  public static double millimetres(double metres) {
    return Math.round(metres * THOUSANDTHS) / THOUSANDTHS;
  }

  /** An angle counted from 0 to a full circle, in tenths of a degree. */
  public static double degreesAround(double radians) {
    double degrees = Math.toDegrees(radians) % FULL_CIRCLE;
    return tenths(degrees < 0 ? degrees + FULL_CIRCLE : degrees) % FULL_CIRCLE;
  }

  static String plain(double value) {
    return SlPrinter.print(value);
  }
}
