package org.maestro.coordination.api;

/** The id of a goal: a coordinator's own prefix and a number, counted from 1. */
public final class GoalId {
  /** Of the central coordinator's goals. */
  public static final String CENTRAL = "G";

  private GoalId() {}

  public static String of(String prefix, int number) {
    return prefix + number;
  }

  /** The number in an id; 0 when it does not begin with that prefix. */
  public static int number(String prefix, String goalId) {
    String digits = goalId.startsWith(prefix) ? goalId.substring(prefix.length()) : "";
    return digits.matches("[0-9]{1,9}") ? Integer.parseInt(digits) : 0;
  }
}
