package org.maestro.sim.sky;

/**
 * The direction of the sun: a vector of length 1 towards it.
 *
 * @param up sine of its elevation, negative below the horizon
 */
public record Sun(double east, double north, double up) {

  private static final double TILT_DEGREES = 23.45;
  private static final double DAYS = 365;
  private static final double DAY_OF_EQUINOX_BEFORE = 284;
  private static final double NOON_HOURS = 12;
  private static final double DEGREES_PER_HOUR = 15;

  /**
   * Declination after Cooper, "The absorption of radiation in solar stills" (1969); the day is
   * counted through beyond midnight.
   *
   * @param latitudeDegrees positive in the north
   * @param dayOfYear 1 is the first of January
   * @param solarHours since midnight, noon being when the sun is highest
   */
  public static Sun at(double latitudeDegrees, double dayOfYear, double solarHours) {
    double declination =
        Math.toRadians(
            TILT_DEGREES * Math.sin(2 * Math.PI * (DAY_OF_EQUINOX_BEFORE + dayOfYear) / DAYS));
    double latitude = Math.toRadians(latitudeDegrees);
    double hour = Math.toRadians(DEGREES_PER_HOUR * (solarHours - NOON_HOURS));
    double upright = Math.cos(declination) * Math.cos(hour);
    return new Sun(
        -Math.cos(declination) * Math.sin(hour),
        Math.cos(latitude) * Math.sin(declination) - Math.sin(latitude) * upright,
        Math.sin(latitude) * Math.sin(declination) + Math.cos(latitude) * upright);
  }

  /** Above the horizon; degrees, negative below. */
  public double elevationDegrees() {
    return Math.toDegrees(Math.asin(Math.max(-1, Math.min(1, up))));
  }
}
