package org.maestro.language.grammar;

/** What a rule awaits next: a word as it is written, or a category. */
public sealed interface Symbol {
  record Word(String text) implements Symbol {}

  /** A category of rules, or of words of the lexicon. */
  record Category(String name) implements Symbol {}
}
