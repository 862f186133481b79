package org.maestro.agents.centre;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.sl.Formula;

/**
 * A goal that was begun before all was said that states it. Agent thread only.
 *
 * <p>Source: ADE, 2 and 4.2 (A12).
 */
final class BegunGoal {
  private final String id;
  private final Formula goal;
  private final String requester;
  private final List<Consumer<GoalOutcome>> followers = new ArrayList<>();
  private Optional<GoalOutcome> outcome = Optional.empty();

  BegunGoal(String id, Formula goal, String requester) {
    this.id = id;
    this.goal = goal;
    this.requester = requester;
  }

  String id() {
    return id;
  }

  Formula goal() {
    return goal;
  }

  String requester() {
    return requester;
  }

  void ended(GoalOutcome how) {
    outcome = Optional.of(how);
    followers.forEach(follower -> follower.accept(how));
    followers.clear();
  }

  /** Tells how it ended, now or then. */
  void follow(Consumer<GoalOutcome> follower) {
    outcome.ifPresentOrElse(follower, () -> followers.add(follower));
  }
}
