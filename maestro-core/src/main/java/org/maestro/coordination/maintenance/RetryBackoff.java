package org.maestro.coordination.maintenance;

import java.time.Duration;

/**
 * The backoff after which a held goal is tried again. What was lost long after it was reached is
 * restored at once, and so are three losses in a row within ten seconds each; after that, and after
 * each attempt that failed, the pauses double, up to a minute. So two held goals that contradict
 * each other do not take turns for ever at full speed.
 */
final class RetryBackoff {
  private static final Duration SOON = Duration.ofSeconds(10);
  private static final Duration SHORTEST = Duration.ofSeconds(2);
  private static final Duration LONGEST = Duration.ofSeconds(60);
  private static final int FREE_LOSSES = 3;

  private Duration heldAt = Duration.ZERO;
  private Duration nextAttempt = Duration.ZERO;
  private int quickLosses;
  private int failures;

  void held(Duration now) {
    heldAt = now;
    failures = 0;
    nextAttempt = now;
  }

  void lost(Duration now) {
    quickLosses = now.minus(heldAt).compareTo(SOON) < 0 ? quickLosses + 1 : 0;
    nextAttempt = now.plus(pause(quickLosses - FREE_LOSSES));
  }

  void failed(Duration now) {
    failures++;
    nextAttempt = now.plus(pause(failures));
  }

  /** Who takes part is not as it was: a new attempt is worth it. */
  void renewed(Duration now) {
    failures = 0;
    nextAttempt = now;
  }

  /** How long it is to be waited, from now. */
  Duration left(Duration now) {
    return nextAttempt.compareTo(now) > 0 ? nextAttempt.minus(now) : Duration.ZERO;
  }

  private static Duration pause(int times) {
    if (times <= 0) {
      return Duration.ZERO;
    }
    Duration pause = SHORTEST.multipliedBy(1L << Math.min(times - 1, 10));
    return pause.compareTo(LONGEST) < 0 ? pause : LONGEST;
  }
}
