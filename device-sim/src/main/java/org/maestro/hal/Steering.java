package org.maestro.hal;

/**
 * The front of a base that has one: where it looks, and turning on the spot. Commands come from the
 * clock's thread, as those of its {@link MobileBase} do; each of both ends what the other is at.
 */
public interface Steering {

  /** Where the front looks, from x towards y; radians. */
  double heading();

  /** Radians a second. */
  double turnSpeed();

  /**
   * Turns on the spot. What is round stays where it is.
   *
   * @param radians from forward towards left; more than a whole turn is turned, too
   */
  void turn(double radians, Completion completion);
}
