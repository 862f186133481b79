package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;

/**
 * Errors of a sensor of persons, each of which lasts for a while, drawn anew after that. Clock
 * thread only.
 */
final class LastingErrors {
  private static final double NANOS = 1e9;

  private final Actuator actuator;
  private final double missShare;
  private final double falseShare;
  private final double seconds;
  private final Map<String, Drawn> byPerson = new HashMap<>();

  /** What goes wrong in a stretch of time: it misses who is there, or takes her to be there. */
  private record Drawn(long stretch, boolean misses, boolean errs) {}

  /**
   * @param seconds how long an error lasts
   */
  LastingErrors(Actuator actuator, double missShare, double falseShare, double seconds) {
    this.actuator = actuator;
    this.missShare = missShare;
    this.falseShare = falseShare;
    this.seconds = seconds;
  }

  /** What is noticed of the person now, if this is so. */
  boolean noticed(String person, boolean so) {
    Duration now = actuator.clock().now();
    long stretch = (long) (now.toNanos() / (seconds * NANOS));
    Drawn drawn = byPerson.get(person);
    if (drawn == null || drawn.stretch() != stretch) {
      drawn = new Drawn(stretch, actuator.happens(missShare), actuator.happens(falseShare));
      byPerson.put(person, drawn);
    }
    return so ? !drawn.misses() : drawn.errs();
  }
}
