package org.maestro.planning.alike;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The facts of a home in which some individuals are not to be thought of. */
final class FactsWithout implements Facts {
  private final Facts all;
  private final Set<Term.Name> spare;

  FactsWithout(Facts all, Set<Term.Name> spare) {
    this.all = all;
    this.spare = spare;
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    return all.truth(atom);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    return all.number(fluent);
  }

  @Override
  public double chanceStill(Formula.Atom atom) {
    return all.chanceStill(atom);
  }

  @Override
  public Optional<Facts> tracing(Consumer<Object> told) {
    return all.tracing(told).map(traced -> new FactsWithout(traced, spare));
  }

  @Override
  public Optional<Set<Object>> changedSince(Facts other) {
    return other instanceof FactsWithout before && spare.equals(before.spare)
        ? all.changedSince(before.all)
        : Optional.empty();
  }

  @Override
  public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    return all.candidates(atom, variable).map(this::others);
  }

  @Override
  public Optional<Set<Term>> aboveZero(Expression.Fluent fluent, String variable) {
    return all.aboveZero(fluent, variable).map(this::others);
  }

  private Set<Term> others(Set<Term> terms) {
    Set<Term> others = new LinkedHashSet<>(terms);
    others.removeAll(spare);
    return others;
  }

  @Override
  public List<List<Term.Name>> alike(Collection<Term.Name> individuals) {
    return all.alike(individuals);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return all.individuals(className).stream().filter(name -> !spare.contains(name)).toList();
  }
}
