package org.maestro.coordination;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.planning.StepKey;
import org.maestro.sl.Formula;

/** What a {@link Journal} is told. */
public sealed interface JournalEntry {

  /** A goal was taken on. Its deadline is on the coordinator's clock. */
  record Submitted(String goalId, GoalRequest request) implements JournalEntry {}

  /**
   * A goal is in another state.
   *
   * @param reason what it waits for, why it is planned again; empty when there is nothing to say
   */
  record Became(String goalId, GoalState state, String reason, GoalEffort effort)
      implements JournalEntry {}

  /**
   * A goal has these for itself from now on.
   *
   * @param components of members
   * @param carried facts that it has brought about, and that tie a member to it
   */
  record Keeps(String goalId, Set<Resource> components, Set<Formula.Atom> carried)
      implements JournalEntry {
    static Keeps nothing(String goalId) {
      return new Keeps(goalId, Set.of(), Set.of());
    }
  }

  /**
   * A call is about to be sent.
   *
   * @param number of the step in its plan
   * @param seconds that the step is expected to take
   */
  record Begun(
      String goalId,
      Crew.Call call,
      StepKey step,
      int number,
      double seconds,
      Map<String, Argument> parameters,
      Duration timeout)
      implements JournalEntry {}

  /** The step of a continuous feature is done, its call goes on. */
  record Established(String goalId, String callId) implements JournalEntry {}

  /** Nobody wants the call any more; it is being cancelled. */
  record CalledOff(String goalId, String callId) implements JournalEntry {}

  /**
   * The call is over.
   *
   * @param problem one sentence; empty when it succeeded
   */
  record Ended(String goalId, String callId, Optional<String> problem) implements JournalEntry {}

  /** A goal has come to its end. */
  record Over(GoalOutcome outcome) implements JournalEntry {}

  /**
   * A member can be used.
   *
   * @param life see {@link Crew.Call}
   */
  record MemberCame(String member, Optional<String> life) implements JournalEntry {}

  record MemberWent(String member, String reason) implements JournalEntry {}
}
