package org.maestro.device.tasks;

import org.maestro.sl.SlPrinter;

/** Numbers as people read them. */
public final class Numbers {

  private static final double TENTHS = 10;
  private static final double THOUSANDTHS = 1000;

  private Numbers() {}

  static double tenths(double value) {
    return Math.round(value * TENTHS) / TENTHS;
  }

  public static double millimetres(double metres) {
    return Math.round(metres * THOUSANDTHS) / THOUSANDTHS;
  }

  static String plain(double value) {
    return SlPrinter.print(value);
  }
}
