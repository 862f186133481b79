package org.maestro.coordination.api;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.Set;

/**
 * The legacy of the coordinators before this one, in times of this one's clock (which are below
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

  /**
   * What concerns one of several coordinators that share a journal.
   *
   * @param prefix of its goals' ids
   */
  public Recovery of(String prefix) {
    List<UnfinishedGoal> own = goals.stream().filter(goal -> isOf(prefix, goal.id())).toList();
    List<EndedGoal> over =
        ended.stream().filter(goal -> isOf(prefix, goal.outcome().id())).toList();
    List<UnfinishedCall> calls =
        unwanted.stream().filter(call -> isOf(prefix, call.begun().goalId())).toList();
    if (prefix.equals(GoalId.CENTRAL)) {
      return new Recovery(lastGoalNumber, own, over, calls, members);
    }
    int last = 0;
    for (UnfinishedGoal goal : own) {
      last = Math.max(last, GoalId.number(prefix, goal.id()));
    }
    for (EndedGoal goal : over) {
      last = Math.max(last, GoalId.number(prefix, goal.outcome().id()));
    }
    return new Recovery(last, own, over, calls, members);
  }

  private static boolean isOf(String prefix, String goalId) {
    return GoalId.number(prefix, GoalId.whole(goalId)) > 0;
  }

  /** Nobody is waited for: they are there, or it does not matter. */
  public Recovery withoutMembers() {
    return new Recovery(lastGoalNumber, goals, ended, unwanted, Set.of());
  }

  /** Nobody was there before. */
  public static final Recovery NOTHING = new Recovery(0, List.of(), List.of(), List.of(), Set.of());

  /**
   * A goal to be taken up.
   *
   * @param keeps what it had for itself
   * @param memory what else it remembered
   * @param calls begun for it, and not known to be over
   * @param lastEnd of its calls that are over
   * @param parts goals that were pursued for steps of it, and for steps of those, and had no end
   *     yet
   * @param endedParts those that had
   */
  public record UnfinishedGoal(
      String id,
      GoalRequest request,
      Duration submittedAt,
      GoalState state,
      String detail,
      GoalEffort effort,
      JournalEntry.Keeps keeps,
      GoalMemory memory,
      List<UnfinishedCall> calls,
      Optional<JournalEntry.Ended> lastEnd,
      List<UnfinishedGoal> parts,
      List<EndedGoal> endedParts) {

    /** The same with these parts. */
    public UnfinishedGoal with(List<UnfinishedGoal> parts, List<EndedGoal> endedParts) {
      return new UnfinishedGoal(
          id,
          request,
          submittedAt,
          state,
          detail,
          effort,
          keeps,
          memory,
          calls,
          lastEnd,
          parts,
          endedParts);
    }

    /** Whether anything was under way for it, or for a step of it. */
    public boolean hasCalls() {
      return !calls.isEmpty() || parts.stream().anyMatch(UnfinishedGoal::hasCalls);
    }
  }

  /**
   * The lessons that a goal has learnt on its way.
   *
   * @param everHeld a held goal was so once
   * @param failures one for each step that failed
   * @param looks in vain, oldest first
   * @param settings that a held goal's steps have made
   * @param asked what an agent has asked of the central one for the goal, and hears the end of yet
   * @param notes how far a script has come
   */
  public record GoalMemory(
      boolean everHeld,
      List<JournalEntry.Failed> failures,
      List<JournalEntry.LookedInVain> looks,
      List<JournalEntry.Setting> settings,
      Optional<JournalEntry.Asked> asked,
      List<JournalEntry.Noted> notes) {}

  public record EndedGoal(GoalRequest request, GoalOutcome outcome) {}

  /**
   * @param begunAt when it was written down
   * @param established its step is done; it goes on as a stream
   */
  public record UnfinishedCall(JournalEntry.Begun begun, Duration begunAt, boolean established) {}
}
