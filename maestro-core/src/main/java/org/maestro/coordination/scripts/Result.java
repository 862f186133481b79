package org.maestro.coordination.scripts;

import java.util.Optional;
import org.maestro.sl.Term;

/** The end of a part of a script. */
sealed interface Result {

  /** What comes next may begin. */
  record Done() implements Result {}

  /** The script that it is a part of is over, and gives this. */
  record Returned(Term value) implements Result {}

  /**
   * @param reason one sentence or more
   */
  record Failed(String reason) implements Result {}

  default Optional<Term> given() {
    return this instanceof Returned returned ? Optional.of(returned.value()) : Optional.empty();
  }

  default Optional<String> problem() {
    return this instanceof Failed failed ? Optional.of(failed.reason()) : Optional.empty();
  }
}
