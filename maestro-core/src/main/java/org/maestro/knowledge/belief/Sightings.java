package org.maestro.knowledge.belief;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/** The conclusions from where things were seen, by the predicates' {@code observedWhen}. */
final class Sightings {

  /** State variables first, then by label, so that the order does not hang on names. */
  private static final Comparator<PredicateDeclaration> IN_ORDER =
      Comparator.comparing(PredicateDeclaration::functional)
          .reversed()
          .thenComparing(PredicateDeclaration::label)
          .thenComparing(PredicateDeclaration::name);

  private final World world;
  private final Snapshot snapshot;

  Sightings(World world, Snapshot snapshot) {
    this.world = world;
    this.snapshot = snapshot;
  }

  /**
   * The facts that the thing's position decides, exclusions first. Where a functional predicate's
   * value is decided, its exclusions are not told.
   */
  List<Fact> of(Term thing) {
    List<Fact> facts = new ArrayList<>();
    world.home().vocabulary().predicates().values().stream()
        .filter(predicate -> predicate.observedWhen().isPresent())
        .sorted(IN_ORDER)
        .forEach(
            predicate ->
                facts.addAll(of(thing, predicate, predicate.observedWhen().orElseThrow())));
    return facts;
  }

  /** Whether the positions now known decide the atom. */
  Truth decided(Formula.Atom atom) {
    return world
        .declarations()
        .declared(atom.predicate())
        .filter(predicate -> predicate.parameters().size() == atom.arguments().size())
        .flatMap(
            predicate ->
                predicate.observedWhen().map(when -> truth(predicate, when, atom.arguments())))
        .orElse(Truth.UNKNOWN);
  }

  private List<Fact> of(Term thing, PredicateDeclaration predicate, Formula when) {
    Set<Formula.Atom> held = new LinkedHashSet<>();
    Set<Formula.Atom> excluded = new LinkedHashSet<>();
    Set<Formula.Atom> asked = new HashSet<>();
    for (List<Term> tuple : tuples(thing, predicate.parameters())) {
      Formula.Atom atom = world.declarations().canonical(new Formula.Atom(predicate.name(), tuple));
      if (!asked.add(atom)) {
        continue;
      }
      switch (truth(predicate, when, tuple)) {
        case TRUE -> held.add(atom);
        case FALSE -> excluded.add(atom);
        case UNKNOWN -> {
          // An unknown position decides nothing.
        }
      }
    }
    Set<StateVariable> decided = new LinkedHashSet<>();
    held.forEach(atom -> decided.add(world.declarations().variable(atom)));
    List<Fact> facts = new ArrayList<>();
    excluded.stream()
        .filter(atom -> !decided.contains(world.declarations().variable(atom)))
        .forEach(atom -> facts.add(new Fact.Excluded(atom)));
    held.forEach(atom -> facts.add(new Fact.Holds(atom)));
    return facts;
  }

  private Truth truth(PredicateDeclaration predicate, Formula when, List<Term> tuple) {
    Map<String, Term> bindings = new LinkedHashMap<>();
    for (int i = 0; i < tuple.size(); i++) {
      bindings.put(predicate.parameters().get(i).name(), tuple.get(i));
    }
    return new Evaluation(snapshot).truth(when, bindings);
  }

  /** All well-typed tuples of different things, this one among them. */
  private List<List<Term>> tuples(Term thing, List<TypedVariable> parameters) {
    List<List<Term>> tuples = new ArrayList<>();
    for (int place = 0; place < parameters.size(); place++) {
      extend(thing, parameters, place, List.of(), tuples);
    }
    return tuples;
  }

  private void extend(
      Term thing,
      List<TypedVariable> parameters,
      int place,
      List<Term> prefix,
      List<List<Term>> tuples) {
    if (prefix.size() == parameters.size()) {
      tuples.add(prefix);
      return;
    }
    String className = parameters.get(prefix.size()).className().orElse("");
    for (Term.Name candidate : snapshot.individuals(className)) {
      boolean fits = prefix.size() == place ? candidate.equals(thing) : !candidate.equals(thing);
      if (fits && !prefix.contains(candidate)) {
        List<Term> longer = new ArrayList<>(prefix);
        longer.add(candidate);
        extend(thing, parameters, place, List.copyOf(longer), tuples);
      }
    }
  }
}
