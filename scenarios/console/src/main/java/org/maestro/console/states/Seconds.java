package org.maestro.console.states;

import java.time.Duration;

/** Wall time in seconds. */
final class Seconds {
  private Seconds() {}

  static double in(Duration time) {
    return Math.round(time.toMillis() / 100.0) / 10.0;
  }

  /** In words, such as {@code 2 s}. */
  static String of(Duration time) {
    double seconds = in(time);
    return seconds == Math.rint(seconds) ? (long) seconds + " s" : seconds + " s";
  }
}
