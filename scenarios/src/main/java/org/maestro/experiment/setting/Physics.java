package org.maestro.experiment.setting;

import java.util.List;
import org.maestro.sim.PhysicalParameters;

/**
 * The physics that can be set in every experiment. Usual values and their sources are those of
 * {@link PhysicalParameters}.
 */
public final class Physics {
  private static final PhysicalParameters USUAL = PhysicalParameters.standard();
  private static final String CAMERA = "world.camera.noise";
  private static final String CAMERA_LIGHT = "world.camera.lightError";
  private static final String SENSOR = "world.sensor.noise";
  private static final String SPEED = "world.base.speed";
  private static final String PLACING = "world.arm.placingError";

  private Physics() {}

  public static List<Setting> settings() {
    return List.of(
        Setting.number(
            CAMERA,
            USUAL.camera().positionError(),
            0,
            0.5,
            "standard deviation of a seen position, per metre of distance; assumed: calibration"),
        Setting.number(
            CAMERA_LIGHT,
            USUAL.camera().lightError(),
            0,
            0.5,
            "relative standard deviation of the light that a camera estimates; assumed"),
        Setting.number(
            SENSOR,
            USUAL.sensor().noise(),
            0,
            0.5,
            "relative standard deviation of the light sensor; assumed"),
        Setting.number(
            SPEED,
            USUAL.base().speed(),
            0.05,
            5,
            "how fast the robot drives, m/s; KUKA youBot's data sheet"),
        Setting.number(
            PLACING,
            USUAL.arm().placingError(),
            0,
            0.5,
            "standard deviation of where the arm puts a thing down, m, each axis; assumed"));
  }

  public static PhysicalParameters of(Settings settings) {
    return USUAL
        .with(USUAL.camera().withErrors(settings.number(CAMERA), settings.number(CAMERA_LIGHT)))
        .with(USUAL.sensor().withNoise(settings.number(SENSOR)))
        .with(USUAL.base().atSpeed(settings.number(SPEED)))
        .with(USUAL.arm().withPlacingError(settings.number(PLACING)));
  }
}
