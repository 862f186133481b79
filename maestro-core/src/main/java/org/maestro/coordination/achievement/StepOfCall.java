package org.maestro.coordination.achievement;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.maestro.coordination.api.ContractNet;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.api.Step;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Self;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** The step by which a member is called as a script says, or why it cannot be. */
record StepOfCall(Optional<Step> step, String problem) {
  private static final int MOST_TRIED = 10_000;

  private static StepOfCall none(String problem) {
    return new StepOfCall(Optional.empty(), problem);
  }

  /**
   * Chooses what is left out so that the feature's condition is known to hold.
   *
   * @param price that the member has named for the feature
   */
  static StepOfCall of(FeatureCall call, Home home, Facts facts, Price price) {
    FeatureType feature = feature(call, home).orElseThrow();
    Map<String, Term> given = new TreeMap<>(call.parameters());
    given.put(Self.NAME, new Term.Name(call.member()));
    List<Parameter> open =
        Stream.concat(feature.inputs().stream(), feature.binds().stream())
            .filter(parameter -> !given.containsKey(parameter.name()))
            .filter(parameter -> !parameter.optional())
            .toList();
    Optional<Parameter> untold =
        open.stream().filter(parameter -> candidates(parameter, facts).isEmpty()).findFirst();
    if (untold.isPresent()) {
      return none(
          "%s of %s needs :%s, and nothing here can stand for it; say it."
              .formatted(call.feature(), call.member(), untold.get().name()));
    }
    Evaluation evaluation = new Evaluation(facts);
    int[] left = {MOST_TRIED};
    return bindings(feature, open, given, evaluation, facts, left)
        .map(
            chosen ->
                new StepOfCall(Optional.of(step(call, feature, chosen, evaluation, price)), ""))
        .orElseGet(
            () ->
                none(
                    "%s cannot %s now: it is not known that %s."
                        .formatted(
                            call.member(),
                            call.feature(),
                            SlPrinter.print(
                                new Substitution(given).apply(feature.precondition())))));
  }

  /** The step at the price that its member names; where it names none, it is told when called. */
  static Step at(Step step, List<ContractNet.Quote> quotes) {
    return quotes.stream()
        .filter(ContractNet.Quote.Priced.class::isInstance)
        .map(ContractNet.Quote.Priced.class::cast)
        .findFirst()
        .map(
            priced ->
                new Step(
                    step.number(),
                    step.member(),
                    step.feature(),
                    step.bindings(),
                    Math.max(step.cost(), priced.cost()),
                    priced.seconds(),
                    true,
                    step.after()))
        .orElse(step);
  }

  /** Whether it is known that the member may do it as things are. */
  static boolean isPossible(Step step, Facts facts) {
    Map<String, Term> values = new TreeMap<>(step.bindings());
    values.put(Self.NAME, new Term.Name(step.member()));
    return new Evaluation(facts).truth(step.feature().precondition(), values) == Truth.TRUE;
  }

  /** The feature that is meant; empty where the member does not offer it. */
  static Optional<FeatureType> feature(FeatureCall call, Home home) {
    return Optional.ofNullable(home.devices().get(call.member())).map(Device::features).stream()
        .flatMap(Collection::stream)
        .filter(feature -> feature.name().equals(call.feature()))
        .findFirst();
  }

  private static List<Term> candidates(Parameter parameter, Facts facts) {
    return parameter.oneOf().isEmpty()
        ? parameter.types().stream()
            .<Term>flatMap(type -> facts.individuals(type).stream())
            .distinct()
            .toList()
        : parameter.oneOf();
  }

  private static Optional<Map<String, Term>> bindings(
      FeatureType feature,
      List<Parameter> open,
      Map<String, Term> given,
      Evaluation evaluation,
      Facts facts,
      int[] left) {
    if (open.isEmpty()) {
      return evaluation.truth(feature.precondition(), given) == Truth.TRUE
          ? Optional.of(given)
          : Optional.empty();
    }
    Parameter next = open.get(0);
    List<Parameter> rest = open.subList(1, open.size());
    for (Term candidate : new ArrayList<>(candidates(next, facts))) {
      if (left[0]-- <= 0) {
        return Optional.empty();
      }
      Map<String, Term> more = new TreeMap<>(given);
      more.put(next.name(), candidate);
      Optional<Map<String, Term>> found = bindings(feature, rest, more, evaluation, facts, left);
      if (found.isPresent()) {
        return found;
      }
    }
    return Optional.empty();
  }

  private static Step step(
      FeatureCall call,
      FeatureType feature,
      Map<String, Term> values,
      Evaluation evaluation,
      Price price) {
    double cost =
        evaluation
            .number(
                price instanceof Price.Stated stated
                    ? stated.cost()
                    : ((Price.Asked) price).atLeast(),
                values)
            .orElse(0);
    double seconds = evaluation.number(feature.seconds(), values).orElse(0);
    Map<String, Term> bindings = new TreeMap<>(values);
    bindings.remove(Self.NAME);
    return new Step(
        1,
        call.member(),
        feature,
        bindings,
        cost,
        seconds,
        price instanceof Price.Stated,
        Set.of());
  }
}
