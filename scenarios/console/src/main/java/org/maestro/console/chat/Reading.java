package org.maestro.console.chat;

import java.util.List;

/** What an utterance was read as. */
sealed interface Reading {

  /** Something that is to be so, in MAESTRO-SL. */
  record Goal(String formula) implements Reading {}

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
