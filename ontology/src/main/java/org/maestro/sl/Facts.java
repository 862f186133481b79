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
   * The individuals of a class, subclasses included, in a stable order; of all classes when the
   * name is "".
   */
  Collection<Term.Name> individuals(String className);
}
