package org.maestro.coordination.api;

/**
 * A mood that an agent shows.
 *
 * @param part of the script that has it shown, such as G7.2
 * @param word for it
 * @param intensity from 0 to 1
 */
public record Mood(String part, String word, double intensity) {

  /** The goal for which it is shown. */
  public String goalId() {
    return GoalId.whole(part);
  }
}
