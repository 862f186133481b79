package org.maestro.hal;

/**
 * The light sensor TSL2561 by TAOS as its data sheet (TAOS059N, 2009) describes it: two counters,
 * one of visible and infrared light, one of infrared alone, that are read with a gain and an
 * integration time, and become lux by a formula. 0.1 to 40,000 lux (Three-layered architecture,
 * 4.1; M83).
 */
public final class Tsl2561 {

  public static final double LEAST_LUX = 0.1;
  public static final double GREATEST_LUX = 40_000;

  /** Counts of the first counter per lux of white light at the highest gain and longest time. */
  public static final double COUNTS_PER_LUX = 35;

  /** Of the second counter to the first, under white light. */
  public static final double INFRARED_SHARE = 3.8 / 35;

  private static final double FIRST = 0.0304;
  private static final double SECOND = 0.062;
  private static final double POWER = 1.4;

  /** Makes the formula right for the light for which {@link #COUNTS_PER_LUX} is stated. */
  private static final double CALIBRATION =
      1 / (COUNTS_PER_LUX * (FIRST - SECOND * Math.pow(INFRARED_SHARE, POWER)));

  private Tsl2561() {}

  /**
   * Gain and integration time, the most sensitive first.
   *
   * @see #lux
   */
  public enum Range {
    SENSITIVE(1, 65_535, 0.402),
    USUAL(1.0 / 16, 65_535, 0.402),
    BRIGHT(1.0 / 16 * 0.252, 37_177, 0.101);

    private final double scale;
    private final int mostCounts;
    private final double seconds;

    Range(double scale, int mostCounts, double seconds) {
      this.scale = scale;
      this.mostCounts = mostCounts;
      this.seconds = seconds;
    }

    /** Of counts, compared with the most sensitive range. */
    public double scale() {
      return scale;
    }

    /** At which a counter stands when there is too much light. */
    public int mostCounts() {
      return mostCounts;
    }

    /** Integration time; seconds. */
    public double seconds() {
      return seconds;
    }
  }

  /**
   * The data sheet's formula for the packages T, FN and CL, for light of which the infrared share
   * is up to one half, as that of lamps, sun and sky is.
   *
   * @param visible counts of the first counter
   * @param infrared counts of the second
   * @return lux within the sensor's range
   */
  public static double lux(int visible, int infrared, Range range) {
    if (visible == 0) {
      return LEAST_LUX;
    }
    double share = (double) infrared / visible;
    double counts = visible / range.scale();
    double lux = FIRST * counts - SECOND * counts * Math.pow(share, POWER);
    return Math.max(LEAST_LUX, Math.min(GREATEST_LUX, CALIBRATION * lux));
  }
}
