package org.maestro.sim.parameters;

/**
 * The times that a robot's head takes. All are assumed, as for small servo motors: no data sheet of
 * such a head is at hand.
 *
 * @param turnSpeed of neck and eyes; degrees per second
 * @param expressionSeconds until lips and brows are where they are to be
 * @param gestureSeconds of one nod, or shake of the head
 * @param pointingSeconds for which a hand points
 */
public record FaceData(
    double turnSpeed, double expressionSeconds, double gestureSeconds, double pointingSeconds) {
  public static final FaceData USUAL = new FaceData(120, 0.4, 0.9, 2);
}
