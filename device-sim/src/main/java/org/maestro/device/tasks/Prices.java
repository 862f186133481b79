package org.maestro.device.tasks;

/** The weights by which members turn time and energy into cost units: one unit is a second. */
final class Prices {

  /**
   * A kilojoule weighs as much as a second: a driving youBot (80 W) adds 8 % to its time. Stated
   * assumption.
   */
  static final double UNITS_PER_JOULE = 0.001;

  /**
   * A pick-up or a putting down begins near the thing, since earlier steps of a plan bring the
   * robot into its zone: no more of the way than this counts for it; metres.
   */
  static final double LONGEST_APPROACH_METRES = 3;

  private Prices() {}
}
