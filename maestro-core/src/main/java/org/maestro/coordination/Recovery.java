package org.maestro.coordination;

import java.time.Duration;
import java.util.List;
import java.util.Set;

/**
 * What the coordinators before this one have left, in times of this one's clock (which are below
 * zero for what was before its start).
 *
 * @param lastGoalNumber the highest that a goal's id has had
 * @param goals without an end, oldest first
 * @param ended how others ended, oldest first
 * @param unwanted calls that may go on though nobody wants them
 * @param members that were there at the end
 */
public record Recovery(
    int lastGoalNumber,
    List<UnfinishedGoal> goals,
    List<EndedGoal> ended,
    List<UnfinishedCall> unwanted,
    Set<String> members) {

  /** Nobody was there before. */
  public static final Recovery NOTHING = new Recovery(0, List.of(), List.of(), List.of(), Set.of());

  /**
   * A goal to be taken up.
   *
   * @param keeps what it had for itself
   * @param calls begun for it, and not known to be over
   */
  public record UnfinishedGoal(
      String id,
      GoalRequest request,
      Duration submittedAt,
      GoalState state,
      String detail,
      GoalEffort effort,
      JournalEntry.Keeps keeps,
      List<UnfinishedCall> calls) {}

  public record EndedGoal(GoalRequest request, GoalOutcome outcome) {}

  /**
   * @param begunAt when it was written down
   * @param established its step is done; it goes on as a stream
   */
  public record UnfinishedCall(JournalEntry.Begun begun, Duration begunAt, boolean established) {}
}
