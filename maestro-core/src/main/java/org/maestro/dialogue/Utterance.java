package org.maestro.dialogue;

import java.util.Optional;

/**
 * What a person says.
 *
 * @param person her name in the home
 * @param room in which she is, by its name in the home; "" when nobody has told
 * @param text as it was written
 * @param asker her name on a secured site, in whose name goals are stated; empty on an open one
 */
public record Utterance(String person, String room, String text, Optional<String> asker) {}
