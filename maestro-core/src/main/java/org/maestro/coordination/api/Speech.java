package org.maestro.coordination.api;

import java.util.List;
import java.util.Optional;

/**
 * A sentence that somebody is to hear.
 *
 * @param part of the script that says it, such as G7.2; who hears two of the same part with the
 *     same text has heard one sentence twice, as after a restart
 * @param to a person or a room, by its name in the home
 * @param wanted an answer, where it is a question
 */
public record Speech(String part, String to, String text, Optional<Wanted> wanted) {

  /** One that wants no answer. */
  public Speech(String part, String to, String text) {
    this(part, to, text, Optional.empty());
  }

  /**
   * @param type a class of the home, or a datatype
   * @param choices answers that would do, some of them where there are many
   */
  public record Wanted(String type, List<String> choices) {
    public Wanted {
      choices = List.copyOf(choices);
    }
  }

  /** The goal for which it is said. */
  public String goalId() {
    return GoalId.whole(part);
  }
}
