package org.maestro.sim.parameters;

/** The reach and payload of an arm, and the times that it takes. */
public record ArmData(
    @Quantity(
            meaning = "how far from the base's middle it grasps",
            unit = "m",
            source =
                "youBot data sheet: 0.655, minus the arm's offset and the hand's angle (assumed)")
        double reach,
    @Quantity(
            meaning = "greatest mass that it lifts",
            unit = "kg",
            source = "youBot data sheet: 0.5")
        double payload,
    @Quantity(meaning = "time for stretching out", unit = "s", source = "assumed")
        double extendSeconds,
    @Quantity(meaning = "time for folding", unit = "s", source = "assumed") double foldSeconds,
    @Quantity(
            meaning = "how far from where it is expected a thing is found by the camera on board",
            unit = "m",
            source = "assumed")
        double graspTolerance,
    @Quantity(
            meaning = "standard deviation of where a thing comes to stand, each axis",
            unit = "m",
            source = "assumed")
        double placingError,
    @Quantity(meaning = "power while moving, pressing and pumping", unit = "W", source = "assumed")
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
