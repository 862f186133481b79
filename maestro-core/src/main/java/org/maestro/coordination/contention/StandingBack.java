package org.maestro.coordination.contention;

import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;

/** For whom a goal stands back, and whether that is so still. The coordinator's thread only. */
public final class StandingBack {
  private final String goal;
  private final ActiveGoals activeGoals;
  private Optional<String> after = Optional.empty();
  private Optional<String> yieldedTo = Optional.empty();

  public StandingBack(String goal, ActiveGoals activeGoals) {
    this.goal = goal;
    this.activeGoals = activeGoals;
  }

  /** Until the other is over. */
  public void untilEndOf(String other) {
    after = Optional.of(other);
  }

  /** Until the other waits for nothing any more. */
  public void untilWayOf(String other) {
    yieldedTo = Optional.of(other);
  }

  public void forget() {
    after = Optional.empty();
    yieldedTo = Optional.empty();
  }

  /** Whether it stands back for one that is not over yet, or has not got its way yet. */
  public boolean isSo() {
    after = after.filter(other -> activeGoals.goesOnBefore(other, goal));
    yieldedTo =
        yieldedTo.filter(other -> activeGoals.goesOnBefore(other, goal) && isOnItsWay(other));
    return after.isPresent() || yieldedTo.isPresent();
  }

  /** It waits; where a goal of another manager has got what it waited for, not for this one. */
  private boolean isOnItsWay(String other) {
    List<WaitsFor> waits = activeGoals.leases().waitsOf(other);
    boolean standsBack =
        activeGoals.otherManagers().areThere()
            && waits.stream().map(WaitsFor::resource).anyMatch(Resource.endOf(goal)::equals);
    return !waits.isEmpty() && !standsBack;
  }
}
