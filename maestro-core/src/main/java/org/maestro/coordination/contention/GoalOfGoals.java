package org.maestro.coordination.contention;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.coordination.story.Decisions;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;

/**
 * A goal for which other goals do all that is done: they hear of members themselves, contend with
 * others, and give way. It has no step, and keeps nothing.
 */
public interface GoalOfGoals extends ActiveGoal {

  @Override
  default Decisions decisions() {
    return new Decisions();
  }

  @Override
  default void memberLost(String member) {
    // It asks nothing of members.
  }

  @Override
  default void advance() {
    // It has no step to begin.
  }

  @Override
  default StepsUnderway underway() {
    return new StepsUnderway();
  }

  @Override
  default boolean isHolding() {
    return false;
  }

  @Override
  default Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other) {
    return Optional.empty();
  }

  @Override
  default boolean isTied(String member) {
    return false;
  }

  @Override
  default double remainingSeconds() {
    return 0;
  }

  @Override
  default OptionalDouble remainingCost() {
    return OptionalDouble.empty();
  }

  @Override
  default double secondsOfRunningSteps() {
    return 0;
  }

  @Override
  default void giveWayTo(String other) {
    // It keeps nothing.
  }

  @Override
  default void standBackFor(String other) {
    // It keeps nothing.
  }

  @Override
  default void stepBackFor(String other) {
    // It keeps nothing.
  }
}
