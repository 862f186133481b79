package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
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

  /**
   * A thing with which nobody can do something.
   *
   * @param reason the numbers of those who are nearest to it
   */
  record Vain(Individual thing, String feature, String reason) {}

  /** A sentence for each feature and thing, in the order of the things. */
  public static List<String> of(Home home) {
    return all(home).stream()
        .map(
            vain ->
                "Nobody can do %s with %s: %s. Correct the numbers, or add a device that can."
                    .formatted(vain.feature(), vain.thing().name(), vain.reason()))
        .toList();
  }

  /** All of them, in the order of the things. */
  static List<Vain> all(Home home) {
    return new ImpossibleUses(home).found();
  }

  /** A feature that a device offers, with those of its conditions that only the home decides. */
  private record Offer(Device device, FeatureType feature, List<Formula> conditions) {}

  /**
   * An offer for things of some classes.
   *
   * @param input for which they may stand
   */
  private record Use(Device device, String input, List<Formula> conditions) {}

  private List<Vain> found() {
    Map<String, List<Offer>> offering = offering();
    Map<Set<String>, Map<String, List<Use>>> usesOf = new HashMap<>();
    List<Vain> found = new ArrayList<>();
    for (Individual thing : home.individuals().values()) {
      usesOf
          .computeIfAbsent(thing.classes(), classes -> uses(offering, classes))
          .forEach((feature, uses) -> vain(thing, feature, uses).ifPresent(found::add));
    }
    return found;
  }

  /** By the name of the feature. */
  private Map<String, List<Offer>> offering() {
    Map<String, List<Offer>> offering = new LinkedHashMap<>();
    for (Device device : home.devices().values()) {
      for (FeatureType feature : device.features()) {
        List<Formula> conditions =
            conjuncts(feature.precondition()).stream().filter(this::isFixed).toList();
        offering
            .computeIfAbsent(feature.name(), name -> new ArrayList<>())
            .add(new Offer(device, feature, conditions));
      }
    }
    return offering;
  }

  /** What is offered for things of these classes, by the name of the feature. */
  private static Map<String, List<Use>> uses(
      Map<String, List<Offer>> offering, Set<String> classes) {
    Map<String, List<Use>> uses = new LinkedHashMap<>();
    offering.forEach(
        (name, offers) -> {
          List<Use> some = offers.stream().flatMap(offer -> use(offer, classes).stream()).toList();
          if (!some.isEmpty()) {
            uses.put(name, some);
          }
        });
    return uses;
  }

  private static Optional<Use> use(Offer offer, Set<String> classes) {
    return offer.feature().inputs().stream()
        .filter(input -> input.types().stream().anyMatch(classes::contains))
        .map(Parameter::name)
        .findFirst()
        .map(
            input ->
                new Use(
                    offer.device(),
                    input,
                    offer.conditions().stream()
                        .filter(part -> isOfBoth(FreeVariables.of(part), input))
                        .toList()));
  }

  /** Whether nothing stands in a condition but the device itself and what is given to it. */
  private static boolean isOfBoth(Set<String> variables, String input) {
    return variables.contains(input) && Set.of(Self.NAME, input).containsAll(variables);
  }

  private Optional<Vain> vain(Individual thing, String feature, List<Use> uses) {
    Map<List<String>, Shortfall> nearest = new LinkedHashMap<>();
    for (Use use : uses) {
      Optional<Shortfall> shortfall = shortfall(use, thing);
      if (shortfall.isEmpty()) {
        return Optional.empty();
      }
      nearest.merge(shortfall.get().numbers(), shortfall.get(), Shortfall::nearer);
    }
    return Optional.of(
        new Vain(
            thing,
            feature,
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

  private Optional<Shortfall> shortfall(Use use, Individual thing) {
    Map<String, Term> bindings =
        Map.of(
            Self.NAME, new Term.Name(use.device().id()), use.input(), new Term.Name(thing.name()));
    return use.conditions().stream()
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
