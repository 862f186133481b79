package org.maestro.dialogue;

import java.util.Optional;

/**
 * What a person says.
 *
 * @param person her name in the home
 * @param room in which she is, by its name in the home; "" when nobody has told
 * @param text as it was written
 * @param asker her name on a secured site, in whose name goals are stated; empty on an open one
 * @param language the tag of the one in which it is said; empty: that which is usual for her
 */
public record Utterance(
    String person, String room, String text, Optional<String> asker, Optional<String> language) {
  /** Something in the language that is usual for her. */
  public Utterance(String person, String room, String text, Optional<String> asker) {
    this(person, room, text, asker, Optional.empty());
  }
}
