package org.maestro.planning.cases;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Quantity;
import org.maestro.planning.problem.Variable;

/**
 * Facts that hold or do not, and bounds of sums: all of them together are one alternative of a
 * condition.
 */
public record Clause(Map<Fact, Boolean> facts, List<Bound> bounds) {
  static final Clause EMPTY = new Clause(Map.of(), List.of());

  /** A proposition about a state, without numeric fluents. */
  public sealed interface Fact {}

  /** A variable has a value. */
  public record Is(Variable variable, int value) implements Fact {}

  /** It is neither known nor excluded that the variable has the value. */
  public record Open(Variable variable, int value) implements Fact {}

  /** A number has a value, perhaps {@link Quantity#UNKNOWN} or {@link Quantity#ANY}. */
  public record Has(NumberVariable variable, double value) implements Fact {}

  /** A word that stands for nothing but itself. */
  public record Said(String word) implements Fact {}

  /**
   * A bound on a sum.
   *
   * @param relation as PDDL writes it
   */
  public record Bound(NumberVariable variable, String relation, double number) {}

  static Clause of(Fact fact, boolean holds) {
    return new Clause(Map.of(fact, holds), List.of());
  }

  /** Both together; empty when they contradict each other. */
  Optional<Clause> and(Clause other) {
    Map<Fact, Boolean> all = new LinkedHashMap<>(facts);
    for (Map.Entry<Fact, Boolean> entry : other.facts.entrySet()) {
      Boolean before = all.put(entry.getKey(), entry.getValue());
      if (before != null && !before.equals(entry.getValue())
          || entry.getValue()
              && all.entrySet().stream().anyMatch(e -> excludes(entry.getKey(), e))) {
        return Optional.empty();
      }
    }
    List<Bound> allBounds = new ArrayList<>(bounds);
    other.bounds.stream().filter(bound -> !bounds.contains(bound)).forEach(allBounds::add);
    return Optional.of(new Clause(all, allBounds));
  }

  /** Of each variable one value holds at most, and none while any is open. */
  private static boolean excludes(Fact fact, Map.Entry<Fact, Boolean> other) {
    if (!other.getValue() || other.getKey().equals(fact)) {
      return false;
    }
    if (fact instanceof Has has) {
      return other.getKey() instanceof Has that && that.variable() == has.variable();
    }
    Optional<Variable> variable = variable(fact);
    return variable.isPresent()
        && variable(other.getKey()).filter(that -> that == variable.get()).isPresent()
        && !(fact instanceof Open && other.getKey() instanceof Open);
  }

  /** The state variable of which a fact says something, if it is one. */
  static Optional<Variable> variable(Fact fact) {
    if (fact instanceof Is is) {
      return Optional.of(is.variable());
    }
    return fact instanceof Open open ? Optional.of(open.variable()) : Optional.empty();
  }

  /** Every one of these with every one of those, without contradictions. */
  static List<Clause> product(List<Clause> these, List<Clause> those) {
    List<Clause> product = new ArrayList<>();
    for (Clause one : these) {
      for (Clause other : those) {
        one.and(other).ifPresent(product::add);
      }
    }
    return product;
  }
}
