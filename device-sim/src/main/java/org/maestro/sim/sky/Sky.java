package org.maestro.sim.sky;

import java.time.Duration;

/**
 * The sky over a place on a day.
 *
 * @param latitudeDegrees positive in the north
 * @param dayOfYear 1 is the first of January
 * @param solarHours when simulated time begins, 12 being when the sun is highest
 */
public record Sky(double latitudeDegrees, int dayOfYear, double solarHours, Clouds clouds) {

  private static final double HOURS_PER_DAY = 24;
  private static final double MILLIS_PER_HOUR = 3_600_000;

  /** The light outdoors so long after the beginning. */
  public Outdoors at(Duration time) {
    double hours = solarHours + time.toMillis() / MILLIS_PER_HOUR;
    double day = dayOfYear + Math.floor(hours / HOURS_PER_DAY);
    Sun sun = Sun.at(latitudeDegrees, day, hours % HOURS_PER_DAY);
    return Availability.of(sun, day, clouds.at(time));
  }

  public Sky with(Clouds other) {
    return new Sky(latitudeDegrees, dayOfYear, solarHours, other);
  }
}
