package org.maestro.coordination.scripts;

import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import org.maestro.coordination.facts.Sensing;
import org.maestro.coordination.facts.WatchedKnowledge;
import org.maestro.coordination.facts.WatchedSnapshot;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Sights;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * A look at a thing: what is to be known of it, by nothing that was seen before the look began.
 *
 * @param goals each reached when one thing is known of it
 * @param names of what these speak of
 */
record Sighting(Term thing, List<Formula> goals, Set<String> names, Instant begun) {

  /** At what the devices of the home can sense of it; none when that is nothing. */
  static Optional<Sighting> of(String thing, KnowledgeBase knowledge) {
    Home home = knowledge.home();
    Set<String> sensed =
        home.devices().values().stream()
            .flatMap(device -> device.features().stream())
            .flatMap(feature -> Sensing.names(feature.effect()).stream())
            .collect(Collectors.toCollection(TreeSet::new));
    List<Formula> goals =
        Optional.ofNullable(home.individuals().get(thing))
            .map(one -> new Sights(home.vocabulary()).of(one, sensed))
            .orElse(List.of());
    Set<String> names = new TreeSet<>();
    goals.forEach(
        goal ->
            Leaves.of(
                goal, atom -> names.add(atom.predicate()), fluent -> names.add(fluent.name())));
    return goals.isEmpty()
        ? Optional.empty()
        : Optional.of(new Sighting(new Term.Name(thing), goals, names, knowledge.snapshot().at()));
  }

  Formula goal() {
    return goals.size() == 1 ? goals.get(0) : new Formula.And(goals);
  }

  /** The knowledge, without what is known of the thing from before. */
  KnowledgeBase since(KnowledgeBase knowledge) {
    return new WatchedKnowledge(
        knowledge,
        now ->
            new WatchedSnapshot(
                now,
                knowledge.home().vocabulary(),
                names,
                atom -> !isOfIt(atom.arguments()) || isNew(now.belief(atom)),
                fluent -> !isOfIt(fluent.arguments()) || isNew(now.belief(fluent))));
  }

  private boolean isOfIt(List<Term> arguments) {
    return !arguments.isEmpty() && arguments.get(0).equals(thing);
  }

  private boolean isNew(Optional<Belief> belief) {
    return belief.filter(known -> !known.since().isBefore(begun)).isPresent();
  }

  /** What is known of it now, as facts. */
  List<String> facts(Snapshot now) {
    return names.stream().flatMap(name -> fact(name, now).stream()).toList();
  }

  private Optional<String> fact(String name, Snapshot now) {
    Expression.Fluent fluent = new Expression.Fluent(name, List.of(thing));
    OptionalDouble number = now.number(fluent);
    if (number.isPresent()) {
      return Optional.of(
          "(= %s %s)".formatted(SlPrinter.print(fluent), SlPrinter.print(number.getAsDouble())));
    }
    Optional<Term> where = now.value(name, List.of(thing));
    if (where.isPresent()) {
      return Optional.of(SlPrinter.print(new Formula.Atom(name, List.of(thing, where.get()))));
    }
    Formula.Atom atom = new Formula.Atom(name, List.of(thing));
    Truth truth = now.truth(atom);
    return truth == Truth.UNKNOWN
        ? Optional.empty()
        : Optional.of(
            truth == Truth.TRUE ? SlPrinter.print(atom) : "(not " + SlPrinter.print(atom) + ")");
  }
}
