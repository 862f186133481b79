package org.maestro.coordination;

/** Where a goal stands. */
public enum GoalState {
  SUBMITTED,
  PLANNING,
  WAITING,
  RUNNING,
  CONFIRMING,
  ACHIEVED,
  FAILED,
  CANCELLED;

  public boolean isFinal() {
    return this == ACHIEVED || this == FAILED || this == CANCELLED;
  }
}
