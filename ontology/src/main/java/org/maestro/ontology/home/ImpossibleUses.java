package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Things with which no device can do what it offers for things of their kind, by numbers that the
 * home states and nothing changes: too heavy for every arm. No fault, since a thing may be there
 * for other ends, but a goal that needs it is in vain.
 */
public final class ImpossibleUses {
  private final Home home;
  private final HomeFacts facts;

  private ImpossibleUses(Home home) {
    this.home = home;
    this.facts = new HomeFacts(home);
  }

  /** A sentence for each feature and thing, in the order of the things. */
  public static List<String> of(Home home) {
    return new ImpossibleUses(home).sentences();
  }

  private List<String> sentences() {
    Map<String, List<Device>> offering = new LinkedHashMap<>();
    for (Device device : home.devices().values()) {
      device
          .features()
          .forEach(
              feature ->
                  offering.computeIfAbsent(feature.name(), f -> new ArrayList<>()).add(device));
    }
    List<String> sentences = new ArrayList<>();
    for (Individual thing : home.individuals().values()) {
      offering.forEach(
          (feature, devices) -> sentence(thing, feature, devices).ifPresent(sentences::add));
    }
    return sentences;
  }

  private Optional<String> sentence(Individual thing, String name, List<Device> devices) {
    Set<String> reasons = new LinkedHashSet<>();
    boolean concerns = false;
    for (Device device : devices) {
      FeatureType feature =
          device.features().stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
      Optional<Parameter> input =
          feature.inputs().stream()
              .filter(p -> p.types().stream().anyMatch(thing.classes()::contains))
              .findFirst();
      concerns |= input.isPresent();
      Optional<String> reason = input.flatMap(p -> obstacle(device, feature, p, thing));
      if (input.isPresent() && reason.isEmpty()) {
        return Optional.empty();
      }
      reason.ifPresent(reasons::add);
    }
    return concerns && !reasons.isEmpty()
        ? Optional.of(
            "Nobody can do %s with %s: %s."
                .formatted(name, thing.name(), String.join("; ", reasons)))
        : Optional.empty();
  }

  private Optional<String> obstacle(
      Device device, FeatureType feature, Parameter input, Individual thing) {
    Map<String, Term> bindings =
        Map.of("self", new Term.Name(device.id()), input.name(), new Term.Name(thing.name()));
    return conjuncts(feature.precondition()).stream()
        .filter(Formula.Comparison.class::isInstance)
        .filter(part -> FreeVariables.of(part).contains(input.name()))
        .filter(part -> bindings.keySet().containsAll(FreeVariables.of(part)) && isFixed(part))
        .filter(part -> new Evaluation(facts).truth(part, bindings) == Truth.FALSE)
        .findFirst()
        .map(part -> words((Formula.Comparison) new Substitution(bindings).apply(part)));
  }

  /** Whether only the home says what the numbers are. */
  private boolean isFixed(Formula comparison) {
    boolean[] fixed = {true};
    Leaves.of(
        comparison,
        atom -> fixed[0] = false,
        fluent ->
            fixed[0] &=
                home.vocabulary()
                    .predicate(fluent.name())
                    .filter(declared -> !declared.observable())
                    .isPresent());
    return fixed[0];
  }

  private String words(Formula.Comparison comparison) {
    return "%s has to be %s %s"
        .formatted(
            side(comparison.left()), comparison.relation().symbol(), side(comparison.right()));
  }

  private String side(Expression expression) {
    if (!(expression instanceof Expression.Fluent fluent)) {
      return SlPrinter.print(expression);
    }
    String label =
        home.vocabulary()
            .predicate(fluent.name())
            .map(PredicateDeclaration::label)
            .orElse(fluent.name());
    OptionalDouble number = facts.number(fluent);
    return "the %s of %s%s"
        .formatted(
            label,
            fluent.arguments().stream()
                .map(SlPrinter::print)
                .reduce((a, b) -> a + ", " + b)
                .orElse(""),
            number.isPresent() ? " (" + SlPrinter.print(number.getAsDouble()) + ")" : "");
  }

  private static List<Formula> conjuncts(Formula formula) {
    return formula instanceof Formula.And and
        ? and.operands().stream().flatMap(part -> conjuncts(part).stream()).toList()
        : List.of(formula);
  }
}
