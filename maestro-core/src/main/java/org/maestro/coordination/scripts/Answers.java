package org.maestro.coordination.scripts;

import java.util.Optional;
import org.maestro.coordination.api.Speech;
import org.maestro.sl.Term;

/** The answers to a question that would do, as people write them. */
interface Answers {

  /** What who is asked is told of them. */
  Speech.Wanted wanted();

  /** What the answer stands for; empty when it would not do. */
  Optional<Term> read(String answer);

  /** What to write instead. */
  String cure();

  /** The number that is written there, if it is one. */
  static Optional<Double> number(String text) {
    return text.matches("[-+]?[0-9]{1,15}([.][0-9]{1,15})?")
        ? Optional.of(Double.parseDouble(text))
        : Optional.empty();
  }
}
