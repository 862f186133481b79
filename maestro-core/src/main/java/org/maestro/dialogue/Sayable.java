package org.maestro.dialogue;

import java.util.List;

/**
 * What can be said in a home.
 *
 * @param patterns of sentences, with roles in braces
 * @param names of rooms, things and persons
 */
public record Sayable(List<String> patterns, List<String> names) {
  public Sayable {
    patterns = List.copyOf(patterns);
    names = List.copyOf(names);
  }
}
