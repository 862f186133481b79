package org.maestro.coordination.api;

/**
 * The effort that a goal took so far.
 *
 * @param plans made, those to have it seen among them
 * @param confirmingPlans made to have it seen
 * @param calls of features begun
 */
public record GoalEffort(int plans, int confirmingPlans, int calls) {
  public static final GoalEffort NONE = new GoalEffort(0, 0, 0);

  public GoalEffort planned(boolean confirming) {
    return new GoalEffort(plans + 1, confirmingPlans + (confirming ? 1 : 0), calls);
  }

  public GoalEffort called() {
    return new GoalEffort(plans, confirmingPlans, calls + 1);
  }

  /** With what a goal took that was pursued for a part of this one. */
  public GoalEffort with(GoalOutcome part) {
    return new GoalEffort(
        Math.max(plans, confirmingPlans + 1) + part.replans(),
        confirmingPlans,
        calls + part.calls());
  }

  /** Plans made after the first, without those to have it seen. */
  public int replans() {
    return Math.max(0, plans - confirmingPlans - 1);
  }
}
