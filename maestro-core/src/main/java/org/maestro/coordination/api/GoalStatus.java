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
    List<WaitsFor> waits) {
  public GoalStatus {
    waits = List.copyOf(waits);
  }

  /** The same goal in another state. */
  public GoalStatus as(GoalState other, String why) {
    return new GoalStatus(id, goal, requester, other, why, priority, timeLeft, age, waits);
  }
}
