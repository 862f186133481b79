package org.maestro.experiment.measuring;

/**
 * The interval that holds a true mean with 95 %, as far as values are distributed normally
 * (Student, 1908).
 *
 * @param least NaN, as is the greatest, of fewer than two values
 */
public record Interval(double least, double greatest) {
  private static final double NORMAL_95 = 1.959964;

  /** For one, two and three degrees of freedom. */
  private static final double[] FEW = {12.706, 4.303, 3.182};

  /** Of the mean of these values. */
  public static Interval ofMean(Spread spread) {
    if (spread.count() < 2) {
      return new Interval(Double.NaN, Double.NaN);
    }
    double half = quantile(spread.count() - 1) * spread.deviation() / Math.sqrt(spread.count());
    return new Interval(spread.mean() - half, spread.mean() + half);
  }

  /** Whether both have a value in common; of one that is unknown nothing speaks against it. */
  public boolean overlaps(Interval other) {
    return !(least > other.greatest || greatest < other.least);
  }

  /** By Fisher's expansion (1925), which is exact to a hundredth from four degrees on. */
  private static double quantile(int freedom) {
    if (freedom <= FEW.length) {
      return FEW[freedom - 1];
    }
    double z = NORMAL_95;
    double cube = z * z * z;
    double fifth = cube * z * z;
    return z
        + (cube + z) / (4.0 * freedom)
        + (5 * fifth + 16 * cube + 3 * z) / (96.0 * freedom * freedom);
  }
}
