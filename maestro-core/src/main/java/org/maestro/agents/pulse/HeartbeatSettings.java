package org.maestro.agents.pulse;

import java.time.Duration;

/**
 * The timing of heartbeats: how often signs of life are given, and what silence means. Wall time,
 * however fast the clock.
 *
 * @param period between two signs of life
 * @param suspectedAfter so much silence nothing is asked of whoever is silent
 * @param lostAfter so much silence somebody is given up for good, and replaced
 */
public record HeartbeatSettings(Duration period, Duration suspectedAfter, Duration lostAfter) {

  /**
   * @throws IllegalArgumentException unless a sign of life may be late without being missed: the
   *     period above zero, suspected after two periods or more, lost two periods or more after that
   */
  public HeartbeatSettings {
    Duration two = period.multipliedBy(2);
    if (period.isNegative()
        || period.isZero()
        || suspectedAfter.compareTo(two) < 0
        || lostAfter.compareTo(suspectedAfter.plus(two)) < 0) {
      throw new IllegalArgumentException(
          "Heartbeats every %d ms, suspected after %d ms, lost after %d ms do not go together; give two periods or more from one to the next."
              .formatted(period.toMillis(), suspectedAfter.toMillis(), lostAfter.toMillis()));
    }
  }

  /** A frozen process is noticed within five seconds, and a busy one is not taken for it. */
  public static HeartbeatSettings standard() {
    return new HeartbeatSettings(
        Duration.ofMillis(500), Duration.ofSeconds(2), Duration.ofSeconds(4));
  }

  /**
   * For so long after a sign of life that was confirmed a container may act. It is shorter than the
   * time after which it is given up, so that what replaces it never acts beside it, whatever the
   * clocks of the hosts say.
   */
  public Duration lease() {
    return lostAfter.minus(period);
  }

  /**
   * So long an agent whose process is alive may do nothing before another takes its place: longer
   * than a process, as it may compute, and nobody waits for it while it is suspected.
   */
  public Duration hungAfter() {
    return lostAfter.multipliedBy(3);
  }
}
