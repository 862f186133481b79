package org.maestro.coordination.api;

/**
 * A sentence that somebody is to hear.
 *
 * @param part of the script that says it, such as G7.2; who hears two of the same part with the
 *     same text has heard one sentence twice, as after a restart
 * @param to a person or a room, by its name in the home
 */
public record Speech(String part, String to, String text) {

  /** The goal for which it is said. */
  public String goalId() {
    return GoalId.whole(part);
  }
}
