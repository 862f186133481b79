package org.maestro.coordination.api;

/** The state of a goal in its life cycle. */
public enum GoalState {
  SUBMITTED,
  PLANNING,
  /**
   * For something that another goal holds, for its own steps to end, or for a member to come back
   * that was lost moments ago; the detail says which.
   */
  WAITING,
  RUNNING,
  REPLANNING,
  /** It has given way to a goal that goes first, and goes on afterwards. */
  SUSPENDED,
  /** What is to be kept is so now. */
  HOLDING,
  CONFIRMING,
  ACHIEVED,
  FAILED,
  CANCELLED;

  public boolean isFinal() {
    return this == ACHIEVED || this == FAILED || this == CANCELLED;
  }
}
