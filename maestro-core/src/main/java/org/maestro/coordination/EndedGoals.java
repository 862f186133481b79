package org.maestro.coordination;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Latest;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.PlanRecords;

/**
 * Goals that are over: how each of the latest ended, what was decided for it, and its plans. What
 * is kept of them is bounded in bytes. The coordinator's thread only.
 */
final class EndedGoals {
  private static final long MOST_BYTES_OF_EXPLAINED = 1 << 20;

  private static final long MOST_BYTES_OF_ENDED = 512 << 10;
  private static final long BYTES_OF_A_REQUEST = 512;

  private final Latest<Recovery.EndedGoal> goals =
      new Latest<>(MOST_BYTES_OF_ENDED, goal -> BYTES_OF_A_REQUEST + goal.outcome().bytes());
  private final Latest<Decisions> explained =
      new Latest<>(MOST_BYTES_OF_EXPLAINED, Decisions::bytes);
  private final Latest<PlanRecords> planned =
      new Latest<>(MOST_BYTES_OF_EXPLAINED, PlanRecords::bytes);

  void put(Recovery.EndedGoal goal) {
    goals.put(goal.outcome().id(), goal);
  }

  /** What was decided and planned for it. */
  void keep(String goalId, ActiveGoal over) {
    explained.put(goalId, over.decisions());
    planned.put(goalId, over.plans());
  }

  Optional<Recovery.EndedGoal> find(String goalId) {
    return goals.find(goalId);
  }

  Optional<Decisions> decisions(String goalId) {
    return explained.find(goalId);
  }

  Optional<PlanRecords> plans(String goalId) {
    return planned.find(goalId);
  }

  /**
   * @param now simulated
   */
  List<GoalStatus> statuses(Duration now) {
    return goals.values().stream().map(goal -> status(goal, now)).toList();
  }

  private static GoalStatus status(Recovery.EndedGoal goal, Duration now) {
    GoalOutcome outcome = goal.outcome();
    return new GoalStatus(
            outcome.id(),
            outcome.goal(),
            goal.request().requester(),
            outcome.state(),
            String.join(" ", outcome.reasons()),
            goal.request().priority(),
            goal.request().deadline().map(deadline -> deadline.minus(now)),
            now.minus(outcome.submittedAt()),
            List.of())
        .stakes(goal.request().stakes());
  }
}
