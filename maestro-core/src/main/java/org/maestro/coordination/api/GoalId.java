package org.maestro.coordination.api;

import java.util.Optional;
import java.util.regex.Pattern;

/**
 * The id of a goal: a coordinator's own prefix and a number, counted from 1. What is pursued for a
 * step of a script has the id of the whole with the step's path, {@code G7.2.1}.
 */
public final class GoalId {
  /** Of the central coordinator's goals. */
  public static final String CENTRAL = "G";

  /** Of what is pursued for a goal beside its plan; steps of scripts are counted from 1. */
  private static final String BESIDE = "0.";

  private static final Pattern PATH = Pattern.compile("(\\.\\d+)+$");
  private static final Pattern NUMBER = Pattern.compile("-\\d+$");

  private GoalId() {}

  /**
   * @param path numbers with dots between them
   */
  public static String part(String whole, String path) {
    return whole + "." + path;
  }

  /** The id of what is pursued for a goal beside its plan, {@code G7.0.1}. */
  public static String beside(String goalId, int number) {
    return part(goalId, BESIDE + number);
  }

  /** The goal that one is pursued for; itself, when it is no part of another. */
  public static String whole(String goalId) {
    return PATH.matcher(goalId).replaceFirst("");
  }

  /** Whose goal it is, where an agent counts its own: {@code keeper} of {@code keeper-3.1}. */
  public static String pursuer(String goalId) {
    return NUMBER.matcher(whole(goalId)).replaceFirst("");
  }

  /** The goal of which one is a part, that may be a part itself; empty for a whole one. */
  public static Optional<String> enclosing(String goalId) {
    return isPart(goalId)
        ? Optional.of(goalId.substring(0, goalId.lastIndexOf('.')))
        : Optional.empty();
  }

  /** The number of a part among those of what encloses it. */
  public static int lastNumber(String partId) {
    return Integer.parseInt(partId.substring(partId.lastIndexOf('.') + 1));
  }

  public static boolean isPart(String goalId) {
    return !whole(goalId).equals(goalId);
  }

  /** Whether one is pursued for a step of the other, or for a step within that. */
  public static boolean isWithin(String part, String other) {
    return part.length() > other.length()
        && part.charAt(other.length()) == '.'
        && part.startsWith(other);
  }

  /**
   * Whether one is pursued for a step of the other, so that it may use what that has. What is
   * pursued beside a goal's plan may not.
   */
  public static boolean isOfStep(String part, String other) {
    return isWithin(part, other) && !isBeside(part, other);
  }

  /** Whether one is pursued beside the other's plan. */
  public static boolean isBeside(String part, String other) {
    return isWithin(part, other) && part.startsWith(BESIDE, other.length() + 1);
  }

  public static String of(String prefix, int number) {
    return prefix + number;
  }

  /** The number in an id; 0 when it does not begin with that prefix. */
  public static int number(String prefix, String goalId) {
    String digits = goalId.startsWith(prefix) ? goalId.substring(prefix.length()) : "";
    return digits.matches("[0-9]{1,9}") ? Integer.parseInt(digits) : 0;
  }
}
