package org.maestro.knowledge;

import java.util.List;
import java.util.Optional;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;

/** What is known at one moment. Immutable; any thread may read it. Too-old facts are unknown in it. */
public interface Snapshot extends Facts {

  /** Grows with each change. */
  long version();

  Optional<Belief> belief(Formula.Atom atom);

  Optional<Belief> belief(Expression.Fluent fluent);

  /** All current dynamic facts (not those described in the home), sorted by their text. */
  List<Belief> beliefs();
}
