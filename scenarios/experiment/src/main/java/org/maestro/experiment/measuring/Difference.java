package org.maestro.experiment.measuring;

import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/**
 * What one of two conditions has more than the other, with the interval that holds the true
 * difference with 95 %.
 *
 * @param value NaN where there was nothing to compare
 * @param interval unknown, NaN, where there was too little
 */
public record Difference(double value, Interval interval) {
  private static final Difference NONE =
      new Difference(Double.NaN, new Interval(Double.NaN, Double.NaN));

  /** Of values that belong together in pairs, by Student's interval of their differences' mean. */
  public static Difference ofPairs(List<Double> before, List<Double> after) {
    Spread spread =
        Spread.of(
            IntStream.range(0, before.size())
                .mapToDouble(i -> after.get(i) - before.get(i))
                .toArray());
    return new Difference(spread.mean(), Interval.ofMean(spread));
  }

  /**
   * Of two shares, as if they had been counted in runs of their own (Newcombe 1998, from Wilson's
   * intervals): that of runs in pairs that end alike would be narrower.
   */
  public static Difference ofShares(Share before, Share after) {
    if (before.of() == 0 || after.of() == 0) {
      return NONE;
    }
    double value = after.value() - before.value();
    double down = Math.hypot(after.value() - after.least(), before.greatest() - before.value());
    double up = Math.hypot(after.greatest() - after.value(), before.value() - before.least());
    return new Difference(value, new Interval(value - down, value + up));
  }

  /** Whether the interval, as {@link #text} tells it, has 0 outside of it. */
  public boolean isShown(double factor, int places) {
    return rounded(factor * interval.least(), places) > 0
        || rounded(factor * interval.greatest(), places) < 0;
  }

  /**
   * Such as {@code +1.20 (0.30 to 2.10)}; "" where there was nothing to compare.
   *
   * @param factor by which numbers are told, 100 for percent
   * @param places behind the point
   */
  public String text(double factor, int places) {
    if (Double.isNaN(value)) {
      return "";
    }
    String difference = signed(factor * value, places);
    return Double.isNaN(interval.least())
        ? difference
        : "%s (%s to %s)"
            .formatted(
                difference,
                signed(factor * interval.least(), places),
                signed(factor * interval.greatest(), places));
  }

  /** Nothing is not below nothing. */
  private static double rounded(double number, int places) {
    double scale = Math.pow(10, places);
    return Math.round(number * scale) / scale + 0.0;
  }

  private static String signed(double number, int places) {
    double rounded = rounded(number, places);
    return String.format(
        Locale.ROOT, rounded == 0 ? "%." + places + "f" : "%+." + places + "f", rounded);
  }
}
