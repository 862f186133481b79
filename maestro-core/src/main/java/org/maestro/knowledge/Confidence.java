package org.maestro.knowledge;

import java.util.List;
import java.util.Optional;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Term;

/** How sure sources are, by what their descriptions say. */
final class Confidence {

  /** How sure a device's observations are; a property of the meta-vocabulary. */
  private static final String PROPERTY = "confidence";

  private Confidence() {}

  /** Of itself a member is sure, of what it observes as sure as its description says. */
  static Voice voice(Home home, Source source) {
    return new Voice(source, source.kind() == Source.Kind.OBSERVED ? of(home, source.agent()) : 1);
  }

  private static double of(Home home, String agent) {
    return Optional.ofNullable(home.individuals().get(agent))
        .map(Individual::properties)
        .map(properties -> properties.getOrDefault(PROPERTY, List.of()))
        .flatMap(values -> values.stream().findFirst())
        .filter(Term.Number.class::isInstance)
        .map(value -> ((Term.Number) value).value())
        .orElse(1.0);
  }
}
