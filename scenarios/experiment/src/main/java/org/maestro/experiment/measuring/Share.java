package org.maestro.experiment.measuring;

import java.util.Locale;

/** So many of so many. */
public record Share(int hits, int of) {
  private static final double NORMAL_95 = 1.959964;

  public double value() {
    return of == 0 ? Double.NaN : (double) hits / of;
  }

  /** The lower end of the interval that holds the true share with 95 % (Wilson 1927). */
  public double least() {
    return middle() - halfWidth();
  }

  /** The upper end of that interval. */
  public double greatest() {
    return middle() + halfWidth();
  }

  private double middle() {
    double square = NORMAL_95 * NORMAL_95;
    return (hits + square / 2) / (of + square);
  }

  private double halfWidth() {
    double square = NORMAL_95 * NORMAL_95;
    return NORMAL_95 / (of + square) * Math.sqrt((double) hits * (of - hits) / of + square / 4);
  }

  /** Such as "9 of 10 (95 % interval 60 to 98 %)". */
  public String text() {
    return of == 0
        ? "none of none"
        : String.format(
            Locale.ROOT,
            "%d of %d (95 %% interval %.0f to %.0f %%)",
            hits,
            of,
            100 * Math.max(0, least()),
            100 * Math.min(1, greatest()));
  }
}
