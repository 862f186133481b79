package org.maestro.hal;

/**
 * How a base moves on the floor, seen from itself.
 *
 * @param forward metres a second
 * @param left metres a second
 * @param turn about its middle, from forward towards left; radians a second
 */
public record Twist(double forward, double left, double turn) {

  public static final Twist STILL = new Twist(0, 0, 0);

  /** Metres a second. */
  public double speed() {
    return Math.hypot(forward, left);
  }
}
