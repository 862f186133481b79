package org.maestro.planning.api;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/** The result of planning: a plan, the proof that there is none, or neither within the bounds. */
public sealed interface PlanningResult {

  /**
   * A plan, proven the best for the task's objective unless a bound says otherwise.
   *
   * @param atLeast empty when proven; else nothing better than this exists: cost units, or seconds
   *     when the earliest finish is wanted
   * @param contenders members of this plan and of others that cost little more, as far as is known
   * @param rivals steps of other plans that may cost no more than this one, as far as is known, in
   *     the order in which they are worth asking for; none where all prices of this plan are exact
   */
  record Found(Plan plan, OptionalDouble atLeast, Set<String> contenders, List<OpenPrice> rivals)
      implements PlanningResult {
    public Found(Plan plan, OptionalDouble atLeast, Set<String> contenders) {
      this(plan, atLeast, contenders, List.of());
    }

    public Found(Plan plan) {
      this(plan, OptionalDouble.empty(), plan.members());
    }

    public Found with(Plan other) {
      return new Found(other, atLeast, contenders, rivals);
    }

    public Found withRivals(List<OpenPrice> others) {
      return new Found(plan, atLeast, contenders, others);
    }
  }

  /** Proven: no plan exists. */
  record Impossible(Explanation explanation) implements PlanningResult {}

  /** Neither plan nor proof within the bounds given; the sentence says which bound. */
  record GaveUp(String reason) implements PlanningResult {}

  /**
   * Why no plan exists: conditions that nobody can bring about. With all of them there is a plan,
   * with any of them left out there is none.
   *
   * @param proven whether that was found by planning; otherwise the search was broken off, and the
   *     conditions are what a simpler reckoning gives
   */
  record Explanation(List<Obstacle> obstacles, boolean proven) {}

  /**
   * A condition that cannot be met.
   *
   * @param condition ground, in MAESTRO-SL: {@code (>= (illuminance zone-b) 72)}; for a member that
   *     is not there its name, for a step that its member does not do the step's sentence
   * @param needed what is needed: {@code >= 72}, {@code true}, {@code present}
   * @param possible the best that can be reached, or what is known: {@code 42}, {@code false}, or
   *     why the member is not there
   * @param extent what is said by what is possible: of a number, of the goal, and of what nobody
   *     can find out
   * @param missing how much more (or, when it is to be less, how much less) would do; empty unless
   *     that is known
   * @param neededBy the step that needs it; empty: the goal itself
   * @param subject who is not there, or which step is not done; empty for other kinds
   * @param cures other conditions that would do instead of this one
   */
  record Obstacle(
      Kind kind,
      String condition,
      String needed,
      String possible,
      Extent extent,
      OptionalDouble missing,
      Optional<StepKey> neededBy,
      Optional<StepKey> subject,
      List<Cure> cures) {

    /** The reason why a condition is not met. */
    public enum Kind {
      /** A number is not enough, and known. */
      NUMBER,
      /** A fact is known to be otherwise. */
      FACT,
      /** Whether it is so was looked for everywhere one could, and it is not. */
      EXCLUDED,
      /** It is not known, and nobody can find out. */
      UNKNOWN,
      /** A member is not there, or takes no part. */
      MEMBER,
      /** A member declined the step, or failed in it. */
      STEP,
      /** The goal itself; nobody can do anything for it. */
      GOAL
    }

    /** The strength of what is told to be possible: how far it goes. */
    public enum Extent {
      /** It is that, as far as is known; how far it can be moved is not told. */
      KNOWN,
      /** Nothing that anybody does brings it further: all was tried, or reckoned. */
      LIMIT,
      /** The same, by those who are there and do not refuse; with others it may be more. */
      LIMIT_NOW,
      /** The best that was found; that there is no better is not proven. */
      FOUND
    }

    public Obstacle neededBy(Optional<StepKey> step) {
      return new Obstacle(kind, condition, needed, possible, extent, missing, step, subject, cures);
    }

    public Obstacle withCures(List<Cure> others) {
      return new Obstacle(
          kind, condition, needed, possible, extent, missing, neededBy, subject, others);
    }

    public Obstacle with(Kind other) {
      return new Obstacle(
          other, condition, needed, possible, extent, missing, neededBy, subject, cures);
    }

    public Obstacle with(Extent reached) {
      return with(possible, reached);
    }

    public Obstacle with(String best, Extent reached) {
      return new Obstacle(
          kind, condition, needed, best, reached, missing, neededBy, subject, cures);
    }
  }

  /**
   * The conditions that would overcome an obstacle.
   *
   * @param conditions all of them together; they name no cures of their own
   */
  record Cure(List<Obstacle> conditions) {}
}
