package org.maestro.launch;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/**
 * A goal to try in a home, from nothing but what the home describes: what an effect of one of its
 * devices brings about, about as many of its things as possible. It need not be reachable.
 */
final class SuggestedGoal {
  private static final String THING = "Thing";
  private static final Term.Variable WHOEVER = new Term.Variable("agent");

  private final List<Individual> things;
  private final List<Individual> others;

  private SuggestedGoal(Home home) {
    List<Individual> inert =
        home.individuals().values().stream()
            .filter(individual -> !home.devices().containsKey(individual.name()))
            .sorted(Comparator.comparingDouble(Individual::order).thenComparing(Individual::name))
            .toList();
    this.things = inert.stream().filter(i -> i.classes().contains(THING)).toList();
    this.others = inert.stream().filter(i -> !i.classes().contains(THING)).toList();
  }

  /** In MAESTRO-SL; empty when no device brings anything about that can be named. */
  static Optional<String> of(Home home) {
    SuggestedGoal suggested = new SuggestedGoal(home);
    return home.devices().values().stream()
        .sorted(Comparator.comparingDouble(Device::order).thenComparing(Device::id))
        .flatMap(device -> device.features().stream())
        .distinct()
        .flatMap(suggested::goals)
        .max(Comparator.comparingLong(suggested::worth))
        .map(SlPrinter::print);
  }

  private Stream<Formula.Atom> goals(FeatureType feature) {
    return added(feature.effect())
        .map(atom -> named(feature, atom))
        .flatMap(Optional::stream)
        .filter(goal -> worth(goal) > 0);
  }

  /** Of several goals of the same worth the first is taken. */
  private long worth(Formula.Atom goal) {
    return things.stream()
        .filter(thing -> goal.arguments().contains(new Term.Name(thing.name())))
        .count();
  }

  private static Stream<Formula.Atom> added(Effect effect) {
    if (effect instanceof Effect.Add add) {
      return Stream.of(add.atom());
    } else if (effect instanceof Effect.All all) {
      return all.effects().stream().flatMap(SuggestedGoal::added);
    }
    return effect instanceof Effect.When when ? added(when.effect()) : Stream.empty();
  }

  /** Each parameter gets an individual of its own; empty when there are not enough. */
  private Optional<Formula.Atom> named(FeatureType feature, Formula.Atom atom) {
    Set<String> used = new LinkedHashSet<>();
    List<Term> arguments = new ArrayList<>();
    for (Term argument : atom.arguments()) {
      Optional<Term> named =
          argument instanceof Term.Variable variable
              ? value(feature, variable.name(), used)
              : Optional.of(argument);
      if (named.isEmpty()) {
        return Optional.empty();
      }
      arguments.add(named.get());
    }
    return Optional.of(new Formula.Atom(atom.predicate(), arguments));
  }

  private Optional<Term> value(FeatureType feature, String variable, Set<String> used) {
    if (variable.equals(Self.NAME)) {
      return Optional.of(WHOEVER);
    }
    List<String> types =
        Stream.of(feature.inputs(), feature.binds())
            .flatMap(List::stream)
            .filter(parameter -> parameter.name().equals(variable))
            .map(Parameter::types)
            .findFirst()
            .orElse(List.of());
    return Stream.concat(things.stream(), others.stream())
        .filter(individual -> types.stream().anyMatch(individual.classes()::contains))
        .map(Individual::name)
        .filter(used::add)
        .findFirst()
        .map(Term.Name::new);
  }
}
