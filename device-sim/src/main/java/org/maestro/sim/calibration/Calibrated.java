package org.maestro.sim.calibration;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.stream.DoubleStream;
import java.util.stream.Stream;
import org.maestro.sim.parameters.CameraData;

/**
 * What a camera's pictures show of a thing.
 *
 * @param camera id of the device
 * @param dark light levels from the darkest on
 * @param bright those from which on things wash out
 * @param whereNothingIs frames that show the thing while it is not there
 * @param nearest distance of the places from the lens; metres, as the farthest
 * @param noise standard deviation of its place on each axis, per metre of distance
 * @param offset mean distance between where it is seen and where it is; metres
 */
public record Calibrated(
    String camera,
    String thing,
    int places,
    double nearest,
    double farthest,
    List<LightLevel> dark,
    List<LightLevel> bright,
    int framesWithoutIt,
    int whereNothingIs,
    double noise,
    double offset) {

  public Calibrated {
    dark = List.copyOf(dark);
    bright = List.copyOf(bright);
  }

  /** Whether it is found in any light. */
  public boolean isFound() {
    return levels().anyMatch(level -> level.shown() > 0);
  }

  /** All levels, from the darkest on. */
  public Stream<LightLevel> levels() {
    // the last of the dark ones is the first of the bright ones
    return Stream.concat(dark.stream(), bright.stream().skip(1));
  }

  /** The least light in which nearly all frames showed it; empty when none did. */
  public OptionalDouble leastLux() {
    return fit().min();
  }

  /** The most light in which nearly all frames showed it; empty when none did. */
  public OptionalDouble greatestLux() {
    return fit().max();
  }

  private DoubleStream fit() {
    return levels()
        .filter(level -> level.rate() >= LogisticFit.FIT_RATE)
        .mapToDouble(LightLevel::lux);
  }

  public LogisticFit inTheDark() {
    return LogisticFit.of(dark, true);
  }

  public LogisticFit overLit() {
    return LogisticFit.of(bright, false);
  }

  /** What the model errs by: root of the mean square, where it errs more. */
  public double meanError() {
    return Math.max(inTheDark().error(dark), overLit().error(bright));
  }

  /** The most that it errs by in any light. */
  public double greatestError() {
    return Math.max(inTheDark().greatestError(dark), overLit().greatestError(bright));
  }

  /** The settings by which the fast model comes nearest, by their names. */
  public Map<String, Double> settings() {
    LogisticFit least = inTheDark();
    LogisticFit most = overLit();
    Map<String, Double> settings = new LinkedHashMap<>();
    settings.put("world.camera.minimumLux", least.fitLux());
    settings.put("world.camera.halfLux", least.halfLux());
    settings.put("world.camera.slopeLux", least.slopeLux());
    settings.put("world.camera.maximumLux", most.halfLux() / CameraData.WASHED_OUT_HALF);
    settings.put("world.camera.washedOutSlopeLux", -most.slopeLux());
    settings.put("world.camera.noise", noise);
    return settings;
  }
}
