package org.maestro.hal;

/**
 * The velocity of a base on the floor, along and about its own axes.
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
