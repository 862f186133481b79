package org.maestro.agents.centre;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.Coordinator;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.sl.Formula;

/**
 * A goal that was begun before all was said that states it: whether it is taken on, and how it
 * ends, is told to all who wish to know, now or then. Agent thread only.
 *
 * <p>Source: ADE, 2 and 4.2 (A12).
 */
final class BegunGoal implements Coordinator.Answer {
  private final Formula goal;
  private final List<Coordinator.Answer> asking = new ArrayList<>();
  private final List<Consumer<GoalOutcome>> followers = new ArrayList<>();
  private Optional<String> id = Optional.empty();
  private Optional<String> refusal = Optional.empty();
  private Optional<GoalOutcome> outcome = Optional.empty();

  BegunGoal(Formula goal) {
    this.goal = goal;
  }

  Formula goal() {
    return goal;
  }

  /** Empty until it is taken on. */
  Optional<String> id() {
    return id;
  }

  boolean isRefused() {
    return refusal.isPresent();
  }

  @Override
  public void accepted(String goalId) {
    id = Optional.of(goalId);
    answered();
  }

  @Override
  public void refused(String reason) {
    refusal = Optional.of(reason);
    answered();
  }

  private void answered() {
    List<Coordinator.Answer> told = List.copyOf(asking);
    asking.clear();
    told.forEach(this::tell);
  }

  /** Tells whether it is taken on. */
  void tell(Coordinator.Answer answer) {
    if (id.isPresent()) {
      answer.accepted(id.get());
    } else if (refusal.isPresent()) {
      answer.refused(refusal.get());
    } else {
      asking.add(answer);
    }
  }

  void ended(GoalOutcome how) {
    outcome = Optional.of(how);
    followers.forEach(follower -> follower.accept(how));
    followers.clear();
  }

  /** Tells how it ended. */
  void follow(Consumer<GoalOutcome> follower) {
    outcome.ifPresentOrElse(follower, () -> followers.add(follower));
  }
}
