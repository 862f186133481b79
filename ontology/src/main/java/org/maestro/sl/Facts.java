package org.maestro.sl;

import java.util.Collection;
import java.util.OptionalDouble;

/**
 * What formulas are evaluated over. All atoms and fluents given to it are ground. Implementations
 * resolve derived and computed predicates themselves.
 */
public interface Facts {

  /** Class membership included: {@code (Thing Cup)}. */
  Truth truth(Formula.Atom atom);

  /** The number, or empty when unknown. */
  OptionalDouble number(Expression.Fluent fluent);

  /**
   * The chance, 0 to 1, that an atom whose truth is unknown holds still, since it was known to hold
   * before; 0 when it never was, or has been found not to hold since.
   */
  default double chanceStill(Formula.Atom atom) {
    return 0;
  }

  /**
   * The individuals of a class, subclasses included, in a stable order; of all classes when the
   * name is "".
   */
  Collection<Term.Name> individuals(String className);
}
