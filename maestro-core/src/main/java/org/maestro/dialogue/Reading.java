package org.maestro.dialogue;

import java.util.List;

/** What an utterance was read as. */
public sealed interface Reading {

  /** Something that is to be so, in MAESTRO-SL. */
  record Goal(String formula) implements Reading {}

  /** Several things that are to be so, each a goal of its own. */
  record Goals(List<String> formulas) implements Reading {
    public Goals {
      formulas = List.copyOf(formulas);
    }
  }

  /** Something that is asked as people speak, and is answered so. */
  record Asked(String formula) implements Reading {}

  /** For how many things this is so. */
  record Counted(String formula) implements Reading {}

  /** Something to say, and nothing to do. */
  record Said(String text) implements Reading {}

  /** A question back. */
  record Back(String text, List<String> choices) implements Reading {}

  /** Something that is asked of what is known, in MAESTRO-SL. */
  record Question(String formula) implements Reading {}

  /**
   * A goal that lacks its last part.
   *
   * @param begin what was said
   * @param wanted the class of what is to be named; "" of a number
   */
  record Unfinished(String begin, String wanted) implements Reading {}

  /** Neither. */
  record Unclear(String why, List<String> near) implements Reading {}
}
