package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.Formula;

/**
 * A wish.
 *
 * @param requester who asks: an agent's name
 * @param priority higher goes first; 0 is usual
 * @param deadline the clock's time by which it has to be reached; later it fails
 * @param stakes what decides how it stands among goals of the same priority; empty: it counts as
 *     any goal
 */
public record GoalRequest(
    Formula goal,
    String requester,
    int priority,
    Optional<Duration> deadline,
    Optional<Stakes> stakes) {

  public static final int USUAL_PRIORITY = 0;

  public GoalRequest with(Stakes stated) {
    return new GoalRequest(goal, requester, priority, deadline, Optional.of(stated));
  }

  /** A wish of which nobody says what it is worth. */
  public GoalRequest(Formula goal, String requester, int priority, Optional<Duration> deadline) {
    this(goal, requester, priority, deadline, Optional.empty());
  }

  /** A wish of usual priority that may take its time. */
  public GoalRequest(Formula goal, String requester) {
    this(goal, requester, USUAL_PRIORITY, Optional.empty());
  }
}
