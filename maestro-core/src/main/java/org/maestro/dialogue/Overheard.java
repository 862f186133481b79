package org.maestro.dialogue;

import java.util.List;

/**
 * What can be told of words after which others are to come (A12, A60, A63).
 *
 * @param begun goals that may be begun before the end, by what was said
 * @param looks individuals that alone can be meant
 * @param complete whether it is certain what is wanted, if nothing else follows
 */
public record Overheard(List<Reading.Goals> begun, List<String> looks, boolean complete) {
  /** Nothing. */
  public static final Overheard NOTHING = new Overheard(List.of(), List.of(), false);

  public Overheard {
    begun = List.copyOf(begun);
    looks = List.copyOf(looks);
  }
}
