package org.maestro.coordination.api;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/** An event of which a {@link Journal} is told. */
public sealed interface JournalEntry {

  /** An entry about one goal. */
  sealed interface OfGoal extends JournalEntry {
    String goalId();
  }

  /** A goal was taken on. Its deadline is on the coordinator's clock. */
  record Submitted(String goalId, GoalRequest request) implements OfGoal {}

  /** A goal was not taken on after all: its first entry was written too late. */
  record Withdrawn(String goalId) implements OfGoal {}

  /**
   * A goal is in another state.
   *
   * @param reason what it waits for, why it is planned again; empty when there is nothing to say
   */
  record Became(String goalId, GoalState state, String reason, GoalEffort effort)
      implements OfGoal {}

  /**
   * A goal has these for itself from now on.
   *
   * @param components of members
   * @param carried facts that it has brought about, and that tie a member to it
   * @param broughtAbout of what its steps have changed facts until now: names of individuals, by
   *     the predicate or fluent that says something of them
   */
  record Keeps(
      String goalId,
      Set<Resource> components,
      Set<Formula.Atom> carried,
      Map<String, Set<String>> broughtAbout)
      implements OfGoal {
    public static Keeps nothing(String goalId) {
      return new Keeps(goalId, Set.of(), Set.of(), Map.of());
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
      ActionDispatcher.Call call,
      StepKey step,
      int number,
      double seconds,
      Map<String, Argument> parameters,
      Duration timeout)
      implements OfGoal {}

  /** The step of a continuous feature is done, its call goes on. */
  record Established(String goalId, String callId) implements OfGoal {}

  /** Nobody wants the call any more; it is being cancelled. */
  record CalledOff(String goalId, String callId) implements OfGoal {}

  /** The call was not begun, as another manager has what it needs, and has its turn later. */
  record NotBegun(String goalId, String callId) implements OfGoal {}

  /**
   * The call is over.
   *
   * @param problem one sentence; empty when it succeeded
   */
  record Ended(String goalId, String callId, Optional<String> problem) implements OfGoal {}

  /**
   * A step of a goal failed; this is all that the goal remembers of that step's failures.
   *
   * @param facts under its precondition, as they were
   * @param count how often it failed with these facts
   * @param chances how often it may
   * @param refused its member said the last time that it cannot be done as things are
   * @param problem what its member said last
   * @param taught what the failure has taught
   */
  record Failed(
      String goalId,
      StepKey step,
      String facts,
      int count,
      int chances,
      boolean refused,
      String problem,
      List<FeatureRun.Learnt> taught)
      implements OfGoal {

    /** One that was tried, and not refused. */
    public Failed(
        String goalId,
        StepKey step,
        String facts,
        int count,
        int chances,
        String problem,
        List<FeatureRun.Learnt> taught) {
      this(goalId, step, facts, count, chances, false, problem, taught);
    }

    public Failed with(int otherCount, int otherChances) {
      return new Failed(goalId, step, facts, otherCount, otherChances, refused, problem, taught);
    }
  }

  /**
   * A look of a goal did not show what it was to show.
   *
   * @param atom what was sought there
   */
  record LookedInVain(String goalId, StepKey step, Formula.Atom atom, SearchReport.Look look)
      implements OfGoal {}

  /** The numbers that the steps of a held goal have set, all of them as they are now. */
  record Settings(String goalId, List<Setting> settings) implements OfGoal {}

  /**
   * A number set by a step of a held goal.
   *
   * @param before it was set
   */
  record Setting(Expression.Fluent fluent, double before, double value, StepKey step) {}

  /**
   * An attempt to bring a held goal about has ended: what it had for itself, and its failures and
   * looks, are of no use to the next.
   */
  record AttemptOver(String goalId) implements OfGoal {}

  /**
   * An agent has asked the central one for what a goal of its own lacks.
   *
   * @param petition the id of the goal that the central agent pursues for it since
   */
  record Asked(String goalId, String petition, Formula effect) implements OfGoal {}

  /**
   * A script has come to know something that it goes by, or has done with a part of itself. What
   * was noted below that part before, and became of goals below it, is of no use any more.
   *
   * @param path of the part, numbers with dots between them
   * @param over it is done with
   * @param value what a variable stands for, which way is taken, or what the part gives
   * @param problem why it failed; empty when it did not
   * @param until of a wait for some time: when that is over
   */
  record Noted(
      String goalId,
      String path,
      boolean over,
      Optional<Term> value,
      Optional<String> problem,
      Optional<Duration> until)
      implements OfGoal {}

  /** A goal has come to its end. */
  record Over(GoalOutcome outcome) implements OfGoal {
    @Override
    public String goalId() {
      return outcome.id();
    }
  }

  /**
   * A member can be used.
   *
   * @param life see {@link ActionDispatcher.Call}
   */
  record MemberCame(String member, Optional<String> life) implements JournalEntry {}

  record MemberWent(String member, String reason) implements JournalEntry {}
}
