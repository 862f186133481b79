package org.maestro.platform.journal;

import java.time.Duration;
import java.time.Instant;
import org.maestro.rats.time.Clock;

/**
 * Relates a clock's time to the wall's, so that times noted on one clock can be read on another
 * that was started later.
 *
 * @param since the instant at which the clock stood at zero
 * @param speed seconds of the clock per second of the wall
 */
record Timeline(Instant since, double speed) {

  static Timeline of(Clock clock) {
    return new Timeline(clock.start(), clock.speed());
  }

  /** What the other clock showed, or would have shown, when this one showed the given time. */
  Duration translate(Duration at, Timeline other) {
    if (equals(other)) {
      return at;
    }
    Instant wall = since.plusNanos(Math.round(at.toNanos() / speed));
    return Duration.ofMillis(
        Math.round(Duration.between(other.since(), wall).toMillis() * other.speed()));
  }
}
