package org.maestro.launch;

/** Checks how fast simulated time is to pass. */
final class Speed {
  private static final double GREATEST = 1_000;

  private Speed() {}

  static void require(double speed) {
    if (!(speed > 0 && speed <= GREATEST)) {
      throw CommandException.badInput(
          "--speed is above 0 and at most %.0f, not %s.".formatted(GREATEST, speed));
    }
  }
}
