package org.maestro.members;

import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.EffectTarget;
import org.maestro.sl.Fact;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * The facts by which it is known when effects are there that come later, and what has to hold
 * meanwhile: a member is heard with them also while it is at something that does not change them.
 */
final class AwaitedFacts {

  private AwaitedFacts() {}

  /**
   * The predicates and numbers that the device's features wait for, but for those being changed.
   */
  static Set<String> names(Device device, Collection<FeatureType> underway) {
    Set<String> names = new LinkedHashSet<>();
    for (FeatureType feature : device.features()) {
      Stream.of(feature.timing().doneWhen(), feature.timing().meanwhile())
          .flatMap(Optional::stream)
          .forEach(
              formula ->
                  Leaves.of(
                      formula,
                      atom -> names.add(atom.predicate()),
                      number -> names.add(number.name())));
    }
    for (FeatureType feature : underway) {
      Stream.concat(Stream.of(feature.effect()), feature.learns().stream())
          .flatMap(effect -> EffectTarget.of(effect).stream())
          .forEach(target -> names.remove(target.name()));
    }
    return names;
  }

  /** Those of the facts that speak of these; what cannot be read speaks of nothing. */
  static List<String> among(List<String> facts, Set<String> names) {
    return facts.stream().filter(fact -> name(fact).filter(names::contains).isPresent()).toList();
  }

  private static Optional<String> name(String text) {
    try {
      return Optional.of(name(SlParser.fact(text)));
    } catch (SlSyntaxException noFact) {
      return Optional.empty();
    }
  }

  private static String name(Fact fact) {
    if (fact instanceof Fact.Equation equation) {
      return equation.fluent().name();
    }
    if (fact instanceof Fact.Holds holds) {
      return holds.atom().predicate();
    }
    return fact instanceof Fact.Excluded excluded
        ? excluded.atom().predicate()
        : ((Fact.Unknown) fact).atom().predicate();
  }
}
