package org.maestro.sl;

import java.util.Collection;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;

/**
 * The world closed over what is known: what is unknown does not hold. A derived predicate that is
 * not observable is derived from it.
 */
public record OnlyKnown(Facts facts) implements Facts {

  @Override
  public Truth truth(Formula.Atom atom) {
    return Truth.of(facts.truth(atom) == Truth.TRUE);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    return facts.number(fluent);
  }

  @Override
  public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    return facts.candidates(atom, variable);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return facts.individuals(className);
  }
}
