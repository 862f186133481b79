package org.maestro.coordination.maintenance;

import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.story.GoalStory;

/** The rest that a held goal takes while another, that goes first, is on its way. */
final class Suspension {
  private final String goalId;
  private final ActiveGoals activeGoals;
  private final Holding holding;
  private final GoalStory story;
  private Optional<String> suspendedFor = Optional.empty();

  Suspension(String goalId, ActiveGoals activeGoals, Holding holding, GoalStory story) {
    this.goalId = goalId;
    this.activeGoals = activeGoals;
    this.holding = holding;
    this.story = story;
  }

  boolean isAgreed() {
    return suspendedFor.isPresent();
  }

  void begin(String other) {
    suspendedFor = Optional.of(other);
    String why = other + " goes first" + activeGoals.whyFirst(other, goalId);
    activeGoals
        .leases()
        .waitFor(goalId, Set.of(), List.of(new WaitsFor(goalId, Resource.endOf(other), other)));
    holding.suspended(why);
    story.suspended(why);
  }

  /** Whether the other is not over, and still goes first; else the rest has an end too. */
  boolean goesOn() {
    if (suspendedFor.isEmpty()) {
      return false;
    }
    if (suspendedFor.filter(other -> activeGoals.goesOnBefore(other, goalId)).isPresent()) {
      return true;
    }
    suspendedFor = Optional.empty();
    activeGoals.leases().stopWaiting(goalId);
    story.goesOn();
    return false;
  }
}
