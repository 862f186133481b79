package org.maestro.coordination.story;

import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.api.GoalState;

/**
 * Phase of a goal: what it is at, or what it waits for. This is the whole table of phases and of
 * the transitions between them; {@code docs/goals.md} shows the same. Some phases last no longer
 * than a decision, or are seen from outside as the one before them: they show no state of their
 * own.
 */
public enum GoalPhase {
  SUBMITTED(GoalState.SUBMITTED, "Stated, and not begun."),
  RECOVERING(GoalState.WAITING, "Taken up after a restart; what was under way then has to end."),
  PLANNING(GoalState.PLANNING, "The first plan is made."),
  REPLANNING(GoalState.REPLANNING, "Another plan is made, since the world disagreed."),
  PLANNING_TO_SEE(GoalState.CONFIRMING, "A plan is made that shows whether it is reached."),
  DECIDING("A plan, or the proof that there is none, is weighed."),
  RUNNING(GoalState.RUNNING, "The steps of its plan are done."),
  LOOKING(GoalState.CONFIRMING, "The steps are done that show whether it is reached."),
  HALTING("Another has what the next steps need; those under way come to their end."),
  WAITING_FOR_TURN(GoalState.WAITING, "Another has what its plan needs, or its script is to hold."),
  WAITING_FOR_STEP(GoalState.WAITING, "A step needs a thing in use, or would spoil a fact."),
  WAITING_FOR_WORTH(GoalState.WAITING, "It costs more than it brings, as things are."),
  WAITING_FOR_RANK(GoalState.WAITING, "There is no plan beside what another keeps, for now."),
  WAITING_FOR_STEPS(GoalState.WAITING, "There is no plan; its own steps have to end first."),
  WAITING_FOR_LOOKS(GoalState.WAITING, "What it seeks is looked for in many places at once."),
  WAITING_FOR_CERTAINTY(GoalState.WAITING, "There is no plan; it is in doubt who is there."),
  WAITING_FOR_MEMBERS(GoalState.WAITING, "There is no plan; who was lost just now may come back."),
  WAITING_FOR_ANOTHER_TRY(GoalState.WAITING, "There is no plan; what was refused is tried again."),
  LISTENING(GoalState.WAITING, "Nobody has seen it; who tells of it unasked has time to."),
  ASKING(GoalState.WAITING, "Nobody can see it; who speaks of it is asked once more."),
  SUSPENDED(GoalState.SUSPENDED, "It gave way to a goal that goes first, and goes on afterwards."),
  CARRYING_OUT(GoalState.RUNNING, "The steps of a script are done, or something is held for them."),
  AWAITING_OCCASION(GoalState.WAITING, "Bound to a time or an event that has not come."),
  FOLLOWING(GoalState.RUNNING, "The goal that it has begun is pursued."),
  BRINGING_ABOUT("To be kept, and not so: it is brought about."),
  HOLDING(GoalState.HOLDING, "To be kept, and so."),
  WAITING_TO_RETRY(GoalState.WAITING, "To be kept, and could not be; it is tried again later."),
  ENDING("Nothing is begun any more; what runs is called off."),
  ACHIEVED(GoalState.ACHIEVED, "It is so."),
  FAILED(GoalState.FAILED, "It is given up, with reasons."),
  CANCELLED(GoalState.CANCELLED, "Somebody has withdrawn it.");

  private final Optional<GoalState> shown;
  private final String meaning;

  GoalPhase(GoalState shown, String meaning) {
    this.shown = Optional.of(shown);
    this.meaning = meaning;
  }

  GoalPhase(String meaning) {
    this.shown = Optional.empty();
    this.meaning = meaning;
  }

  /** The state that people and other goals see; empty: the one of the phase before. */
  public Optional<GoalState> shown() {
    return shown;
  }

  /** One sentence. */
  public String meaning() {
    return meaning;
  }

  /** The phases that may come next. */
  public Set<GoalPhase> next() {
    return switch (this) {
      case SUBMITTED ->
          EnumSet.of(
              PLANNING,
              RECOVERING,
              CARRYING_OUT,
              WAITING_FOR_TURN,
              AWAITING_OCCASION,
              FOLLOWING,
              BRINGING_ABOUT,
              ENDING);
      case RECOVERING ->
          EnumSet.of(
              RECOVERING,
              PLANNING,
              REPLANNING,
              CARRYING_OUT,
              WAITING_FOR_TURN,
              AWAITING_OCCASION,
              FOLLOWING,
              BRINGING_ABOUT,
              ENDING);
      case PLANNING, REPLANNING, PLANNING_TO_SEE -> EnumSet.of(DECIDING, ENDING);
      case DECIDING ->
          EnumSet.of(
              RUNNING,
              LOOKING,
              REPLANNING,
              PLANNING_TO_SEE,
              WAITING_FOR_RANK,
              WAITING_FOR_STEPS,
              WAITING_FOR_LOOKS,
              WAITING_FOR_CERTAINTY,
              WAITING_FOR_MEMBERS,
              WAITING_FOR_ANOTHER_TRY,
              LISTENING,
              ASKING,
              ENDING);
      case RUNNING, LOOKING ->
          EnumSet.of(
              REPLANNING,
              PLANNING_TO_SEE,
              HALTING,
              WAITING_FOR_TURN,
              WAITING_FOR_STEP,
              WAITING_FOR_LOOKS,
              WAITING_FOR_WORTH,
              LISTENING,
              ASKING,
              SUSPENDED,
              ENDING);
      case WAITING_FOR_TURN -> {
        EnumSet<GoalPhase> next = EnumSet.of(CARRYING_OUT);
        next.addAll(HALTING.next());
        yield next;
      }
      case HALTING, WAITING_FOR_WORTH ->
          EnumSet.of(
              RUNNING,
              LOOKING,
              WAITING_FOR_TURN,
              WAITING_FOR_WORTH,
              REPLANNING,
              PLANNING_TO_SEE,
              SUSPENDED,
              ENDING);
      case WAITING_FOR_STEP ->
          EnumSet.of(
              RUNNING,
              LOOKING,
              WAITING_FOR_STEP,
              HALTING,
              WAITING_FOR_TURN,
              WAITING_FOR_WORTH,
              REPLANNING,
              PLANNING_TO_SEE,
              LISTENING,
              ASKING,
              SUSPENDED,
              ENDING);
      case WAITING_FOR_RANK,
          WAITING_FOR_STEPS,
          WAITING_FOR_LOOKS,
          WAITING_FOR_CERTAINTY,
          WAITING_FOR_MEMBERS,
          WAITING_FOR_ANOTHER_TRY ->
          EnumSet.of(REPLANNING, PLANNING_TO_SEE, LISTENING, ASKING, ENDING);
      case LISTENING, ASKING -> EnumSet.of(REPLANNING, PLANNING_TO_SEE, ENDING);
      case SUSPENDED ->
          EnumSet.of(
              SUSPENDED,
              RUNNING,
              LOOKING,
              WAITING_FOR_WORTH,
              REPLANNING,
              PLANNING_TO_SEE,
              LISTENING,
              ASKING,
              HOLDING,
              WAITING_TO_RETRY,
              BRINGING_ABOUT,
              CARRYING_OUT,
              ENDING);
      case CARRYING_OUT -> EnumSet.of(CARRYING_OUT, SUSPENDED, ENDING);
      case AWAITING_OCCASION -> EnumSet.of(AWAITING_OCCASION, FOLLOWING, ENDING);
      case FOLLOWING -> EnumSet.of(FOLLOWING, ENDING);
      case BRINGING_ABOUT -> EnumSet.of(HOLDING, WAITING_TO_RETRY, BRINGING_ABOUT, ENDING);
      case HOLDING -> EnumSet.of(HOLDING, BRINGING_ABOUT, WAITING_TO_RETRY, SUSPENDED, ENDING);
      case WAITING_TO_RETRY ->
          EnumSet.of(BRINGING_ABOUT, HOLDING, WAITING_TO_RETRY, SUSPENDED, ENDING);
      case ENDING -> EnumSet.of(ACHIEVED, FAILED, CANCELLED);
      case ACHIEVED, FAILED, CANCELLED -> EnumSet.noneOf(GoalPhase.class);
    };
  }

  /** The phase in which it is made or tried for the goal to have a plan. */
  public boolean isPlanning() {
    return this == PLANNING || this == REPLANNING || this == PLANNING_TO_SEE;
  }

  /** Whether it has no turn now, and its plan rests. */
  public boolean isResting() {
    return this == HALTING
        || this == WAITING_FOR_TURN
        || this == WAITING_FOR_WORTH
        || this == SUSPENDED;
  }

  /** Whether nothing is begun any more. */
  public boolean isOver() {
    return this == ENDING || shown.filter(GoalState::isFinal).isPresent();
  }

  /** The end that is shown so. */
  static GoalPhase of(GoalState end) {
    return switch (end) {
      case ACHIEVED -> ACHIEVED;
      case FAILED -> FAILED;
      case CANCELLED -> CANCELLED;
      default -> throw new IllegalArgumentException(end + " is no end");
    };
  }
}
