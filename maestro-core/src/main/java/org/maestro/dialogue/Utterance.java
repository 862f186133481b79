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
 * @param listener the room agent with whose words it is understood; empty: with all of the home
 */
public record Utterance(
    String person,
    String room,
    String text,
    Optional<String> asker,
    Optional<String> language,
    Optional<String> listener) {
  /** Something that is understood with all words of the home. */
  public Utterance(
      String person, String room, String text, Optional<String> asker, Optional<String> language) {
    this(person, room, text, asker, language, Optional.empty());
  }

  /** Something in the language that is usual for her. */
  public Utterance(String person, String room, String text, Optional<String> asker) {
    this(person, room, text, asker, Optional.empty());
  }

  /** The same, in other words. */
  public Utterance saying(String words) {
    return new Utterance(person, room, words, asker, language, listener);
  }

  /** The same, said in another room. */
  public Utterance in(String otherRoom) {
    return new Utterance(person, otherRoom, text, asker, language, listener);
  }

  /** The same, understood with the words of a room agent. */
  public Utterance heardBy(String agent) {
    return new Utterance(person, room, text, asker, language, Optional.of(agent));
  }
}
