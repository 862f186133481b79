package org.maestro.language.reference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Predicate;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** Chooses among things that fit a description, as it says. Bound to one situation. */
final class Choosing {
  private static final String OTHER = "other";

  private final Situation situation;
  private final Relations relations;
  private final Surroundings surroundings;

  Choosing(Situation situation, Relations relations, Surroundings surroundings) {
    this.situation = situation;
    this.relations = relations;
    this.surroundings = surroundings;
  }

  /**
   * Those that may be meant: several where their numbers are the same, and all where a number is
   * not known, as nobody can tell then.
   */
  List<Term.Name> chosen(Description description, List<Term.Name> candidates) {
    return chosenOf(description, among(description, candidates));
  }

  /** Those that are here, where any are and it was not said where. */
  private List<Term.Name> among(Description description, List<Term.Name> candidates) {
    boolean arePlaces =
        situation.here().map(Term.Name::new).filter(candidates::contains).isPresent();
    List<Term.Name> here =
        description.placed() || arePlaces ? List.of() : surroundings.here(candidates);
    return here.isEmpty() ? candidates : here;
  }

  private List<Term.Name> chosenOf(Description description, List<Term.Name> among) {
    if (description.choice() instanceof Choice.Nth nth) {
      int index = nth.number() < 0 ? among.size() - 1 : nth.number() - 1;
      return index >= 0 && index < among.size() ? List.of(among.get(index)) : List.of();
    }
    return description.choice() instanceof Choice.Extreme extreme
        ? extremes(extreme, among)
        : among;
  }

  /**
   * So many that come first, by their number or in their order; more of them where it is not known
   * which these are, and fewer where there are not so many.
   */
  List<Term.Name> first(Description description, List<Term.Name> candidates, int number) {
    List<Term.Name> left = new ArrayList<>(among(description, candidates));
    List<Term.Name> first = new ArrayList<>();
    while (first.size() < number && !left.isEmpty()) {
      List<Term.Name> next = List.copyOf(chosenOf(description, left));
      if (next.isEmpty()) {
        return List.of();
      }
      first.addAll(next);
      left.removeAll(next);
    }
    return first;
  }

  private List<Term.Name> extremes(Choice.Extreme extreme, List<Term.Name> among) {
    Optional<PredicateDeclaration> fluent =
        fluent(
            extreme, declared -> among.stream().allMatch(one -> relations.fits(declared, 0, one)));
    if (fluent.isEmpty()) {
      return List.of();
    }
    Map<Term.Name, Double> numbers = new HashMap<>();
    for (Term.Name one : among) {
      OptionalDouble number = situation.facts().number(of(fluent.get(), one));
      if (number.isEmpty()) {
        return among;
      }
      numbers.put(one, number.getAsDouble());
    }
    Comparator<Double> order = Comparator.naturalOrder();
    Optional<Double> best =
        numbers.values().stream().max(extreme.greatest() ? order : order.reversed());
    return among.stream()
        .filter(one -> best.filter(numbers.getOrDefault(one, Double.NaN)::equals).isPresent())
        .toList();
  }

  /** The number that is meant; one of two things is that from who speaks. */
  private Optional<PredicateDeclaration> fluent(
      Choice.Extreme extreme, Predicate<PredicateDeclaration> fits) {
    return extreme.fluents().stream()
        .map(name -> situation.home().vocabulary().predicate(name))
        .flatMap(Optional::stream)
        .filter(
            declared ->
                declared.parameters().size() == 1
                    || declared.parameters().size() == 2 && situation.speaker().isPresent())
        .filter(fits)
        // What is measured is meant rather than what was set for it.
        .min(Comparator.comparing(declared -> !declared.observable()));
  }

  private Expression.Fluent of(PredicateDeclaration fluent, Term thing) {
    List<Term> arguments = new ArrayList<>(List.of(thing));
    if (fluent.parameters().size() == 2) {
      situation.speaker().ifPresent(name -> arguments.add(new Term.Name(name)));
    }
    return new Expression.Fluent(fluent.name(), arguments);
  }

  /**
   * What of an extreme one can be said by a formula: no other that is so has more, or less.
   *
   * @param conditions of the description
   * @return empty where the things have no such number
   */
  Optional<Formula> condition(Choice.Extreme extreme, String className, List<Formula> conditions) {
    Term.Variable other = new Term.Variable(OTHER);
    Substitution others = new Substitution(Map.of(Description.IT, other));
    return fluent(extreme, declared -> relations.fits(declared, 0, className))
        .map(
            fluent ->
                new Formula.Comparison(
                    extreme.greatest() ? Formula.Relation.AT_LEAST : Formula.Relation.AT_MOST,
                    of(fluent, Description.VARIABLE),
                    of(fluent, other)))
        .map(
            more -> {
              List<Formula> so = conditions.stream().map(others::apply).toList();
              return new Formula.Forall(
                  List.of(new TypedVariable(OTHER, Optional.of(className))),
                  so.isEmpty()
                      ? more
                      : new Formula.Imply(so.size() == 1 ? so.get(0) : new Formula.And(so), more));
            });
  }
}
