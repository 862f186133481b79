package org.maestro.sim.parameters;

/**
 * The times that a robot's head takes. All are assumed, as for small servo motors: no data sheet of
 * such a head is at hand.
 */
public record FaceData(
    @Quantity(
            meaning = "speed of neck and eyes",
            unit = "degrees/s",
            source = "assumed, as for small servo motors: no data sheet of such a head is at hand")
        double turnSpeed,
    @Quantity(
            meaning = "time until lips and brows are where they are to be",
            unit = "s",
            source = "assumed")
        double expressionSeconds,
    @Quantity(meaning = "time of one nod, or shake of the head", unit = "s", source = "assumed")
        double gestureSeconds,
    @Quantity(meaning = "time for which a hand points", unit = "s", source = "assumed")
        double pointingSeconds) {
  public static final FaceData USUAL = new FaceData(120, 0.4, 0.9, 2);
}
