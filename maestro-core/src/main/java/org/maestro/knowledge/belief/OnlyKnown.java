package org.maestro.knowledge.belief;

import java.util.Collection;
import java.util.OptionalDouble;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The world closed over what is known: what a derived predicate that is not observable is derived
 * from.
 */
record OnlyKnown(Facts facts) implements Facts {

  @Override
  public Truth truth(Formula.Atom atom) {
    return Truth.of(facts.truth(atom) == Truth.TRUE);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    return facts.number(fluent);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return facts.individuals(className);
  }
}
