package org.maestro.language.hearing;

import java.util.Optional;

/**
 * A word that was heard, and what became of it.
 *
 * @param as the word that it was taken for, where it was misheard
 */
public record Heard(String word, Fate fate, Optional<String> as) {
  /** What became of a word. */
  public enum Fate {
    TAKEN,
    FILLER,
    REPAIR,
    WITHDRAWN,
    MISHEARD,
    UNKNOWN,
    UNPLACED
  }

  Heard(String word, Fate fate) {
    this(word, fate, Optional.empty());
  }
}
