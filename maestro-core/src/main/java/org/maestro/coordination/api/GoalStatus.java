package org.maestro.coordination.api;

import java.time.Duration;
import java.util.List;
import java.util.Optional;

/**
 * A line of the list of goals.
 *
 * @param detail why it is in this state; empty when there is nothing to say
 * @param timeLeft until its deadline; negative when that has passed
 * @param age since it was stated, by the clock
 * @param waits what it waits for, and who has that
 * @param worth what it is worth now; empty when nobody says what it is worth
 * @param stakes what was stated of that
 */
public record GoalStatus(
    String id,
    String goal,
    String requester,
    GoalState state,
    String detail,
    int priority,
    Optional<Duration> timeLeft,
    Duration age,
    List<WaitsFor> waits,
    Optional<Worth> worth,
    Optional<Stakes> stakes) {
  public GoalStatus {
    waits = List.copyOf(waits);
  }

  /** A goal of which nobody says what it is worth. */
  public GoalStatus(
      String id,
      String goal,
      String requester,
      GoalState state,
      String detail,
      int priority,
      Optional<Duration> timeLeft,
      Duration age,
      List<WaitsFor> waits) {
    this(
        id,
        goal,
        requester,
        state,
        detail,
        priority,
        timeLeft,
        age,
        waits,
        Optional.empty(),
        Optional.empty());
  }

  /** The same goal, and what it is worth now. */
  public GoalStatus worth(Optional<Worth> now) {
    return new GoalStatus(
        id, goal, requester, state, detail, priority, timeLeft, age, waits, now, stakes);
  }

  /** The same goal, and what was stated of its worth. */
  public GoalStatus stakes(Optional<Stakes> stated) {
    return new GoalStatus(
        id, goal, requester, state, detail, priority, timeLeft, age, waits, worth, stated);
  }

  /** The same goal in another state. */
  public GoalStatus as(GoalState other, String why) {
    return new GoalStatus(
        id, goal, requester, other, why, priority, timeLeft, age, waits, worth, stakes);
  }
}
