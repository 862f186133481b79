package org.maestro.planning;

import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The facts of a small world, which tell on what their answers rest: names, derived ones apart. */
record TellingFacts(SmallWorld world, Optional<Consumer<Object>> told) implements Facts {
  TellingFacts(SmallWorld world) {
    this(world, Optional.empty());
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    var word = Optional.ofNullable(world.predicates.get(atom.predicate()));
    var definition = word.flatMap(declared -> declared.derivedWhen());
    if (definition.isEmpty()) {
      told.ifPresent(reader -> reader.accept(atom.predicate()));
      return world.truth(atom);
    }
    Map<String, Term> bindings = new LinkedHashMap<>();
    for (int i = 0; i < word.get().parameters().size(); i++) {
      bindings.put(word.get().parameters().get(i).name(), atom.arguments().get(i));
    }
    return new Evaluation(this).truth(definition.get(), bindings);
  }

  @Override
  public Optional<Set<Term>> candidates(Formula.Atom atom, String variable) {
    told.ifPresent(reader -> reader.accept(atom.predicate()));
    return world.candidates(atom, variable);
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    told.ifPresent(reader -> reader.accept(fluent.name()));
    return world.number(fluent);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return world.individuals(className);
  }

  @Override
  public Optional<Facts> tracing(Consumer<Object> reader) {
    return Optional.of(new TellingFacts(world, Optional.of(reader)));
  }

  @Override
  public Optional<Set<Object>> changedSince(Facts other) {
    return other instanceof TellingFacts before
        ? Optional.of(Set.copyOf(world.namesChangedSince(before.world())))
        : Optional.empty();
  }
}
