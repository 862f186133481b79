package org.maestro.sim.parameters;

/**
 * The reach and payload of an arm, and the times that it takes.
 *
 * @param reach from the base's middle; youBot data sheet: the arm reaches 0.655 m, minus its offset
 *     and the hand's angle (assumed)
 * @param payload youBot data sheet: 0.5 kg
 * @param extendSeconds assumed; so is the following
 * @param graspTolerance how far from where it is expected a thing is found by the camera on board;
 *     assumed
 * @param placingError standard deviation of where a thing comes to stand, each axis; assumed
 * @param power watts while moving, pressing and pumping; assumed
 */
public record ArmData(
    double reach,
    double payload,
    double extendSeconds,
    double foldSeconds,
    double graspTolerance,
    double placingError,
    double power) {
  public static final ArmData YOUBOT = new ArmData(0.5, 0.5, 1.5, 1.0, 0.15, 0.01, 40);

  public ArmData lifting(double other) {
    return new ArmData(
        reach, other, extendSeconds, foldSeconds, graspTolerance, placingError, power);
  }

  public ArmData reaching(double other) {
    return new ArmData(
        other, payload, extendSeconds, foldSeconds, graspTolerance, placingError, power);
  }

  /**
   * The same arm with another standard deviation of where things come to stand; metres, each axis.
   */
  public ArmData withPlacingError(double other) {
    return new ArmData(reach, payload, extendSeconds, foldSeconds, graspTolerance, other, power);
  }
}
