package org.maestro.sim.scene;

import java.time.Duration;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import org.maestro.sim.sky.Clouds;
import org.maestro.sim.sky.Sky;

/**
 * The sky that a scene states.
 *
 * @param latitudeDegrees of the home, positive in the north
 * @param dayOfYear 1 is the first of January
 * @param solarHours of the beginning, 12 being when the sun is highest
 * @param northDegrees where north is on the map, from x towards y
 * @param cloudSeed of clouds that are the same whatever the run's seed is
 * @param celsius how warm it is outdoors, where the scene says so
 */
public record SceneSky(
    double latitudeDegrees,
    int dayOfYear,
    double solarHours,
    double northDegrees,
    double cloudCover,
    double cloudChange,
    Duration cloudsEvery,
    OptionalLong cloudSeed,
    OptionalDouble celsius) {

  public Sky sky(long runSeed) {
    return new Sky(
        latitudeDegrees,
        dayOfYear,
        solarHours,
        new Clouds(cloudCover, cloudChange, cloudsEvery, cloudSeed.orElse(runSeed)));
  }
}
