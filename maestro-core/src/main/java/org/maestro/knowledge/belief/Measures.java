package org.maestro.knowledge.belief;

import java.util.List;
import java.util.OptionalDouble;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The geometry functions, asked by their local names. */
public interface Measures {

  /** Whether a function of this name exists and tells a number. */
  boolean isNumber(String function);

  /** Whether a function of this name exists and tells a truth. */
  boolean isTruth(String function);

  /**
   * The number, or empty when a place or property it needs is unknown; the snapshot tells the
   * positions.
   */
  OptionalDouble number(String function, List<Term> arguments, Snapshot snapshot);

  Truth truth(String function, List<Term> arguments, Snapshot snapshot);
}
