package org.maestro.coordination.api;

import java.time.Instant;

/**
 * An answer that a script has taken to a question of its own, as it is kept (ADE, 3.3; A45).
 *
 * @param at the home's clock when it was taken
 * @param script by its name
 * @param goal that asks for the script, in MAESTRO-SL
 * @param part of the script that asked, such as G7.2
 * @param to the person, or the room, that was asked
 * @param by whose answer it is
 * @param question as it was asked
 * @param answer what it was read as: of a thing its name
 */
public record GivenAnswer(
    Instant at,
    String script,
    String goal,
    String part,
    String to,
    Respondent by,
    String question,
    String answer) {

  /** Whose answer it is: of the person who was asked, where nobody says otherwise. */
  public String person() {
    return by.person().orElse(to);
  }
}
