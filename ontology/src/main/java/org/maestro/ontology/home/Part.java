package org.maestro.ontology.home;

import java.util.Optional;
import java.util.stream.Stream;

/**
 * A part of agents that a home can open to some callers alone ({@code maestro:opens}): who may have
 * a goal pursued need not be one whose words are read, and who may ask what is known need not be
 * one who tells it (ADE, 3.1; A29).
 */
public enum Part {
  /** To state goals, to give them up and to answer their questions. */
  GOALS("goals"),

  /** To have words of people read. */
  UNDERSTANDING("understanding"),

  /** To ask what is known. */
  MEMORY("memory"),

  /** To tell what is to be known. */
  TELLING("telling"),

  /** To hear of goals that others have stated. */
  STORIES("stories"),

  /** To add, move, configure and remove agents, and to stop devices. */
  ADMINISTRATION("administration");

  private final String word;

  Part(String word) {
    this.word = word;
  }

  /** As the vocabulary names it. */
  public String word() {
    return word;
  }

  static Optional<Part> of(String word) {
    return Stream.of(values()).filter(part -> part.word.equals(word)).findFirst();
  }
}
