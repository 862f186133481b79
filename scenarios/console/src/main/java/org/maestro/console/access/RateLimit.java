package org.maestro.console.access;

import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Map;
import java.util.Optional;
import org.maestro.rats.bounded.BoundedMap;

/**
 * A limit to how often each of many may ask: so often at once, and then once in each stretch of
 * time. Any thread.
 */
final class RateLimit {
  private static final int MOST_KNOWN = 10_000;

  private final int atOnce;
  private final Duration each;
  private final InstantSource clock;

  /** When each would have asked for the last time, had all come evenly. */
  private final Map<String, Instant> spent = BoundedMap.ofLatelyUsed(MOST_KNOWN);

  RateLimit(int atOnce, Duration each, InstantSource clock) {
    this.atOnce = atOnce;
    this.each = each;
    this.clock = clock;
  }

  /** Counts a request of somebody; returns how long she has to wait where it is one too many. */
  synchronized Optional<Duration> take(String who) {
    Instant now = clock.instant();
    Instant since = spent.getOrDefault(who, now);
    Instant next = (since.isBefore(now) ? now : since).plus(each);
    Duration over = Duration.between(now, next).minus(each.multipliedBy(atOnce));
    if (over.compareTo(Duration.ZERO) > 0) {
      return Optional.of(over);
    }
    spent.put(who, next);
    return Optional.empty();
  }

  /** Counts one of them no more. */
  synchronized void giveBack(String who) {
    spent.computeIfPresent(who, (name, at) -> at.minus(each));
  }
}
