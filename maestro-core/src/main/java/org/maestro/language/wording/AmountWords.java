package org.maestro.language.wording;

import java.time.Duration;
import java.time.LocalTime;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.language.grammar.Grammar;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.wording.Measure;

/** Numbers as people say them: shares, times of day, spans, else with their unit. Immutable. */
final class AmountWords {
  private static final double HUNDRED = 100;
  private static final int MINUTES_IN_DAY = 1440;
  private static final String SECONDS = "SEC";

  private final Home home;
  private final Phrases phrases;
  private final SpanWords spans;

  AmountWords(Home home, Grammar grammar) {
    this.home = home;
    this.phrases = new Phrases(grammar);
    this.spans = new SpanWords(grammar);
  }

  /** So much of what the fluent tells, as finely as people are told it. */
  String of(String fluent, double number) {
    OptionalDouble grain =
        Optional.ofNullable(home.wording().measures().get(fluent))
            .map(Measure::grain)
            .orElse(OptionalDouble.empty());
    return exactly(
        fluent,
        grain.isPresent() && grain.getAsDouble() > 0
            ? Math.round(number / grain.getAsDouble()) * grain.getAsDouble()
            : number);
  }

  /** The same of a number that is a bound, and none that was measured. */
  String exactly(String fluent, double number) {
    Optional<Measure> measure = Optional.ofNullable(home.wording().measures().get(fluent));
    if (measure.filter(one -> one.whole().orElse(0) == 1).isPresent()) {
      return phrases.of("percent", Map.of("number", phrases.digits(number * HUNDRED)));
    }
    if (measure.filter(Measure::timeOfDay).isPresent() && number >= 0 && number < MINUTES_IN_DAY) {
      return LocalTime.MIDNIGHT.plusMinutes(Math.round(number)).toString();
    }
    Optional<PredicateDeclaration> declared = home.vocabulary().predicate(fluent);
    return declared.flatMap(PredicateDeclaration::unit).filter(SECONDS::equals).isPresent()
        ? spans.exactly(Duration.ofSeconds(Math.round(number)))
        : phrases.digits(number) + declared.map(PredicateDeclaration::unitAfterNumber).orElse("");
  }
}
