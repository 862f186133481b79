package org.maestro.console.access;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.bounded.BoundedMap;

/**
 * A limit to how often each of many may do something: so often at once, and then once in each
 * stretch of time. Any thread.
 */
final class RateLimit {
  private static final int MOST_KNOWN = 10_000;

  private final int atOnce;
  private final Duration each;
  private final InstantSource clock;

  /** When each would have done it for the last time, had all come evenly. */
  private final Map<String, Instant> spent = BoundedMap.ofLatelyUsed(MOST_KNOWN);

  RateLimit(int atOnce, Duration each, InstantSource clock) {
    this.atOnce = atOnce;
    this.each = each;
    this.clock = clock;
  }

  /** Counts one; returns how long to wait where it is one too many, which is not counted. */
  synchronized Optional<Duration> take(String who) {
    Optional<Duration> wait = wouldWait(who);
    if (wait.isEmpty()) {
      spent.put(who, next(who));
    }
    return wait;
  }

  /** How long one would have to wait now; empty: not at all. */
  synchronized Optional<Duration> wouldWait(String who) {
    Duration over = Duration.between(clock.instant(), next(who)).minus(each.multipliedBy(atOnce));
    return over.compareTo(Duration.ZERO) > 0 ? Optional.of(over) : Optional.empty();
  }

  private Instant next(String who) {
    Instant now = clock.instant();
    Instant since = spent.getOrDefault(who, now);
    return (since.isBefore(now) ? now : since).plus(each);
  }
}
