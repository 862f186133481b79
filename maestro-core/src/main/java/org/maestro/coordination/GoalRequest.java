package org.maestro.coordination;

import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.Formula;

/**
 * A wish.
 *
 * @param requester who asks: an agent's name
 * @param priority higher goes first; 0 is usual
 * @param deadline the clock's time by which it has to be reached; later it fails
 */
public record GoalRequest(
    Formula goal, String requester, int priority, Optional<Duration> deadline) {

  /** A wish of usual priority that may take its time. */
  public GoalRequest(Formula goal, String requester) {
    this(goal, requester, 0, Optional.empty());
  }
}
