package org.maestro.sim.sky;

/**
 * Daylight availability, the light that a clear sky, an overcast one and the sun give by the sun's
 * elevation: IES RP-21, "Recommended practice for the calculation of daylight availability" (1984),
 * also in the IES Lighting Handbook. A partly clouded sky is a clear and an overcast one in their
 * shares, as DOE-2 reckons (Winkelmann and Selkowitz 1985).
 */
final class Availability {

  /** Illuminance of the sun outside the air; lux. */
  private static final double SOLAR = 127_500;

  private static final double ECCENTRICITY = 0.034;
  private static final double DAY_NEAREST_TO_SUN = 2;
  private static final double DAYS = 365;

  /** Extinction of a clear sky's air. */
  private static final double CLEAR_EXTINCTION = 0.21;

  private static final double CLEAR_LEAST = 800;
  private static final double CLEAR_GROWING = 15_500;
  private static final double CLEAR_POWER = 0.5;

  private static final double OVERCAST_LEAST = 300;
  private static final double OVERCAST_GROWING = 21_000;

  /**
   * Twilight fades by this factor per degree below the horizon, so that some 3.4 lux are left of
   * some 400 at 6 degrees, the end of civil twilight (RCA Electro-Optics Handbook 1974); none at
   * all after 18 degrees.
   */
  private static final double FADING_PER_DEGREE = Math.log(400 / 3.4) / 6;

  private static final double NIGHT_DEGREES = -18;

  private Availability() {}

  static Outdoors of(Sun sun, double dayOfYear, double cover) {
    double elevation = sun.elevationDegrees();
    if (elevation < NIGHT_DEGREES) {
      return new Outdoors(sun, 0, 0, 0);
    }
    double up = Math.max(0, sun.up());
    double twilight = Math.exp(FADING_PER_DEGREE * Math.min(0, elevation));
    double clear = twilight * (CLEAR_LEAST + CLEAR_GROWING * Math.pow(up, CLEAR_POWER));
    double overcast = twilight * (OVERCAST_LEAST + OVERCAST_GROWING * up);
    return new Outdoors(
        sun, (1 - cover) * direct(up, dayOfYear), (1 - cover) * clear, cover * overcast);
  }

  private static double direct(double up, double dayOfYear) {
    if (up <= 0) {
      return 0;
    }
    double nearness =
        1 + ECCENTRICITY * Math.cos(2 * Math.PI * (dayOfYear - DAY_NEAREST_TO_SUN) / DAYS);
    return SOLAR * nearness * Math.exp(-CLEAR_EXTINCTION / up);
  }
}
