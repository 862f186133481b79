package org.maestro.sim.calibration;

/**
 * What was seen in one light.
 *
 * @param lux upon the thing, mean of all places
 * @param frames that were taken
 * @param shown those that show it where it is
 * @param elsewhere those that show something else as it
 */
public record LightLevel(double lux, int frames, int shown, int elsewhere) {

  /** The share of the frames that show it, 0 to 1. */
  public double rate() {
    return (double) shown / frames;
  }
}
