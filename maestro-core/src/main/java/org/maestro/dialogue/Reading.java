package org.maestro.dialogue;

import java.util.List;
import java.util.Optional;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

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

  /**
   * Something that is asked about what is being done.
   *
   * @param formula what it is about; empty: what was asked for last
   */
  record About(What what, Optional<Formula> formula) implements Reading {
    /** What is asked. */
    public enum What {
      DOING,
      DONE,
      PLANNED,
      ASKED,
      WHETHER_DONE,
      LASTS,
      WHO,
      WHY
    }
  }

  /**
   * What can be done.
   *
   * @param place where; empty: anywhere
   */
  record Able(Optional<Term> place) implements Reading {}

  /**
   * Something is not to be done any more.
   *
   * @param formula what; empty: what was asked for last
   */
  record CalledOff(Optional<Formula> formula) implements Reading {}

  /** What was asked for last is to be as it was before. */
  record Undone() implements Reading {}

  /** What was asked for last is to be done again. */
  record Again() implements Reading {}

  /** A yes, or a no. */
  record Agreed(boolean yes, String reply) implements Reading {}

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
