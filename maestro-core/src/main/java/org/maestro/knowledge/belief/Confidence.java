package org.maestro.knowledge.belief;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.Doubt;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Self;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The confidence of sources in what they say, by their descriptions. */
public final class Confidence {

  /** How sure a device's observations are; a property of the meta-vocabulary. */
  private static final String PROPERTY = "confidence";

  private Confidence() {}

  /** Of itself a member is sure, of what it observes as sure as its description says. */
  public static Voice voice(Home home, Source source) {
    return new Voice(source, source.kind() == Source.Kind.OBSERVED ? of(home, source.agent()) : 1);
  }

  /** Of what a result of the member's feature teaches. */
  public static Voice voice(Home home, Source source, FeatureRun run, Facts present) {
    Voice voice = voice(home, source);
    if (voice.expects() || !run.succeeded()) {
      return voice;
    }
    Map<String, Term> bindings = Self.is(run.member(), run.bindings());
    double most =
        run.feature().doubts().stream()
            .filter(doubt -> bindings.keySet().containsAll(FreeVariables.of(doubt.when())))
            .filter(doubt -> new Evaluation(present).truth(doubt.when(), bindings) != Truth.FALSE)
            .mapToDouble(Doubt::confidence)
            .min()
            .orElse(1);
    return new Voice(source, voice.confidence() * most, coveredShare(run));
  }

  private static OptionalDouble coveredShare(FeatureRun run) {
    return run.feature().outputs().stream()
        .filter(output -> output.types().contains(Parameter.COVERED_SHARE))
        .map(output -> run.outputs().get(output.name()))
        .filter(Term.Number.class::isInstance)
        .mapToDouble(share -> ((Term.Number) share).value())
        .findFirst();
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
