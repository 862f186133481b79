package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.stream.Collectors;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Parameter;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.Self;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Things with which no device can do what it offers for things of their kind, by numbers that the
 * home states and nothing changes: too heavy for every arm, too wide for every gripper. No fault,
 * since a thing may be there for other ends, but a goal that needs it is in vain.
 */
public final class ImpossibleUses {
  private final Home home;
  private final HomeFacts facts;
  private final ToldNumbers told;

  private ImpossibleUses(Home home) {
    this.home = home;
    this.facts = new HomeFacts(home);
    this.told = new ToldNumbers(home);
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
    Map<List<String>, Shortfall> nearest = new LinkedHashMap<>();
    for (Device device : devices) {
      FeatureType feature =
          device.features().stream().filter(f -> f.name().equals(name)).findFirst().orElseThrow();
      Optional<Parameter> input =
          feature.inputs().stream()
              .filter(p -> p.types().stream().anyMatch(thing.classes()::contains))
              .findFirst();
      if (input.isEmpty()) {
        continue;
      }
      Optional<Shortfall> shortfall = shortfall(device, feature, input.get(), thing);
      if (shortfall.isEmpty()) {
        return Optional.empty();
      }
      nearest.merge(shortfall.get().numbers(), shortfall.get(), Shortfall::nearer);
    }
    return nearest.isEmpty()
        ? Optional.empty()
        : Optional.of(
            "Nobody can do %s with %s: %s. Correct the numbers, or add a device that can."
                .formatted(
                    name,
                    thing.name(),
                    nearest.values().stream().map(this::words).collect(Collectors.joining("; "))));
  }

  /** A comparison of numbers that fails, and by how much. */
  private record Shortfall(Formula.Comparison comparison, double missing, int devices) {
    /** What is compared, of whomever. */
    List<String> numbers() {
      return List.of(name(comparison.left()), name(comparison.right()));
    }

    private static String name(Expression expression) {
      return expression instanceof Expression.Fluent fluent
          ? fluent.name()
          : SlPrinter.print(expression);
    }

    Shortfall nearer(Shortfall other) {
      Shortfall near = other.missing < missing ? other : this;
      return new Shortfall(near.comparison, near.missing, devices + other.devices);
    }
  }

  private Optional<Shortfall> shortfall(
      Device device, FeatureType feature, Parameter input, Individual thing) {
    Map<String, Term> bindings =
        Map.of(Self.NAME, new Term.Name(device.id()), input.name(), new Term.Name(thing.name()));
    return conjuncts(feature.precondition()).stream()
        .filter(part -> FreeVariables.of(part).contains(input.name()))
        .filter(part -> bindings.keySet().containsAll(FreeVariables.of(part)) && isFixed(part))
        .filter(part -> new Evaluation(facts).truth(part, bindings) == Truth.FALSE)
        .flatMap(part -> comparisons(part).stream())
        .map(part -> (Formula.Comparison) new Substitution(bindings).apply((Formula) part))
        .flatMap(part -> missing(part).stream().mapToObj(by -> new Shortfall(part, by, 1)))
        .findFirst();
  }

  /** Empty where no numbers are compared. */
  private OptionalDouble missing(Formula.Comparison comparison) {
    Evaluation evaluation = new Evaluation(facts);
    OptionalDouble left = evaluation.number(comparison.left(), Map.of());
    OptionalDouble right = evaluation.number(comparison.right(), Map.of());
    return left.isPresent() && right.isPresent()
        ? OptionalDouble.of(Math.abs(left.getAsDouble() - right.getAsDouble()))
        : OptionalDouble.empty();
  }

  /** Whether only the home says what is so. */
  private boolean isFixed(Formula formula) {
    boolean[] fixed = {true};
    Leaves.of(
        formula,
        atom -> fixed[0] &= home.vocabulary().predicate(atom.predicate()).isEmpty(),
        fluent ->
            fixed[0] &=
                home.vocabulary().predicate(fluent.name()).isPresent()
                    && !told.isTold(fluent.name()));
    return fixed[0];
  }

  private String words(Shortfall shortfall) {
    Formula.Comparison comparison = shortfall.comparison();
    return "%s has to be %s %s%s"
        .formatted(
            side(comparison.left()),
            comparison.relation().inWords(),
            side(comparison.right()),
            shortfall.devices() > 1 ? ", the nearest of " + shortfall.devices() : "");
  }

  private String side(Expression expression) {
    if (!(expression instanceof Expression.Fluent fluent)) {
      return SlPrinter.print(expression);
    }
    Optional<PredicateDeclaration> declared = home.vocabulary().predicate(fluent.name());
    OptionalDouble number = facts.number(fluent);
    return "the %s of %s%s"
        .formatted(
            declared.map(PredicateDeclaration::label).orElse(fluent.name()),
            fluent.arguments().stream().map(SlPrinter::print).collect(Collectors.joining(", ")),
            number.isPresent()
                ? " (%s%s)"
                    .formatted(
                        SlPrinter.print(number.getAsDouble()),
                        declared.map(PredicateDeclaration::unitAfterNumber).orElse(""))
                : "");
  }

  /** What a formula demands, or allows instead of something else. */
  private static List<Formula.Comparison> comparisons(Formula formula) {
    if (formula instanceof Formula.Comparison comparison) {
      return List.of(comparison);
    } else if (formula instanceof Formula.Or or) {
      return or.operands().stream().flatMap(part -> comparisons(part).stream()).toList();
    }
    return List.of();
  }

  private static List<Formula> conjuncts(Formula formula) {
    return formula instanceof Formula.And and
        ? and.operands().stream().flatMap(part -> conjuncts(part).stream()).toList()
        : List.of(formula);
  }
}
