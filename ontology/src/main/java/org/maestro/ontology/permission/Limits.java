package org.maestro.ontology.permission;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Formula.Relation;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Tells of a condition whether it can be met for what is wanted, and by how much it is missed. */
final class Limits {
  private final Ways ways;
  private final Facts facts;

  Limits(Ways ways, Facts facts) {
    this.ways = ways;
    this.facts = facts;
  }

  /**
   * Whether the condition may hold: what is not decided yet, or may become so by what somebody
   * does, may be so.
   *
   * @param wanted of the number that the goal decides; empty where it decides none
   */
  boolean mayHold(Formula condition, Way way, Optional<Wanted> wanted) {
    Formula known = new Substitution(way.values()).apply(condition);
    if (wanted.isEmpty() || way.number().isEmpty()) {
      return mayHold(known);
    }
    return points(known, wanted.get()).stream()
        .anyMatch(number -> mayHold(with(known, way.number(), number)));
  }

  /**
   * The number that the goal wants to have.
   *
   * @param fluent of which it is
   */
  record Wanted(Expression.Fluent fluent, Relation relation, double number) {
    private boolean takes(double value) {
      return holds(relation, value, number);
    }
  }

  /** Where a condition of comparisons changes, between these, and beyond. */
  private static List<Double> points(Formula condition, Wanted wanted) {
    TreeSet<Double> numbers = new TreeSet<>(List.of(wanted.number()));
    constants(condition, numbers);
    List<Double> all = new ArrayList<>(numbers);
    List<Double> points = new ArrayList<>(all);
    points.add(all.get(0) - 1);
    points.add(all.get(all.size() - 1) + 1);
    IntStream.range(1, all.size())
        .mapToObj(i -> (all.get(i - 1) + all.get(i)) / 2)
        .forEach(points::add);
    return points.stream().filter(wanted::takes).toList();
  }

  private static void constants(Formula formula, Set<Double> numbers) {
    if (formula instanceof Formula.Comparison comparison) {
      constant(comparison.left()).ifPresent(numbers::add);
      constant(comparison.right()).ifPresent(numbers::add);
    }
    formula.parts().forEach(part -> constants(part, numbers));
  }

  private static Optional<Double> constant(Expression expression) {
    return expression instanceof Expression.OfTerm term && term.term() instanceof Term.Number number
        ? Optional.of(number.value())
        : Optional.empty();
  }

  private static Formula with(Formula condition, String variable, double number) {
    return new Substitution(Map.of(variable, new Term.Number(number))).apply(condition);
  }

  private boolean mayHold(Formula condition) {
    if (condition instanceof Formula.And and) {
      return and.operands().stream().allMatch(this::mayHold);
    } else if (condition instanceof Formula.Or or) {
      return or.operands().stream().anyMatch(this::mayHold);
    }
    return !FreeVariables.of(condition).isEmpty()
        || !ways.isFixed(condition)
        || new Evaluation(facts).truth(condition, Map.of()) != Truth.FALSE;
  }

  /** The bound that is missed, where the condition has one for what the goal wants. */
  Optional<Objection.Limit> missed(Formula condition, Way way, Optional<Wanted> wanted) {
    if (wanted.isEmpty() || way.number().isEmpty()) {
      return Optional.empty();
    }
    Formula known = new Substitution(way.values()).apply(condition);
    return parts(known)
        .filter(part -> isMissed(part, way.number(), wanted.get()))
        .flatMap(part -> bound(part, way.number()).stream())
        .map(bound -> new Objection.Limit(wanted.get().fluent(), bound.relation(), bound.number()))
        .findFirst();
  }

  private static Stream<Formula> parts(Formula formula) {
    return formula instanceof Formula.And and
        ? and.operands().stream().flatMap(Limits::parts)
        : Stream.of(formula);
  }

  private boolean isMissed(Formula part, String parameter, Wanted wanted) {
    return points(part, wanted).stream()
        .noneMatch(number -> mayHold(with(part, parameter, number)));
  }

  /** The bound of a comparison; of several that may do, the widest. */
  private static Optional<Bound> bound(Formula formula, String parameter) {
    if (!(formula instanceof Formula.Or or)) {
      return bound(formula, parameter, true);
    }
    List<Optional<Bound>> bounds =
        or.operands().stream().map(one -> bound(one, parameter, true)).toList();
    return bounds.isEmpty()
        ? Optional.empty()
        : bounds.stream().reduce((one, other) -> widest(one, other)).orElseThrow();
  }

  private static Optional<Bound> widest(Optional<Bound> one, Optional<Bound> other) {
    if (one.isEmpty() || other.isEmpty() || isUpper(one.get()) != isUpper(other.get())) {
      return Optional.empty();
    }
    boolean isWider =
        isUpper(one.get())
            ? one.get().number() >= other.get().number()
            : one.get().number() <= other.get().number();
    return isWider ? one : other;
  }

  private static boolean isUpper(Bound bound) {
    return bound.relation() == Relation.AT_MOST || bound.relation() == Relation.LESS;
  }

  private record Bound(Relation relation, double number) {}

  /** A comparison of the parameter with a number; the parameter on the left. */
  private static Optional<Bound> bound(Formula formula, String parameter, boolean holding) {
    if (formula instanceof Formula.Not not) {
      return bound(not.operand(), parameter, !holding);
    }
    if (!(formula instanceof Formula.Comparison comparison)) {
      return Optional.empty();
    }
    boolean isLeft = isParameter(comparison.left(), parameter);
    Optional<Double> number = constant(isLeft ? comparison.right() : comparison.left());
    if (number.isEmpty() || !isLeft && !isParameter(comparison.right(), parameter)) {
      return Optional.empty();
    }
    Relation relation = isLeft ? comparison.relation() : mirrored(comparison.relation());
    if (!holding && relation == Relation.EQUAL) {
      return Optional.empty();
    }
    return Optional.of(new Bound(holding ? relation : opposite(relation), number.get()));
  }

  private static boolean isParameter(Expression expression, String name) {
    return expression instanceof Expression.OfTerm term
        && term.term() instanceof Term.Variable variable
        && variable.name().equals(name);
  }

  private static Relation mirrored(Relation relation) {
    return switch (relation) {
      case EQUAL -> Relation.EQUAL;
      case LESS -> Relation.GREATER;
      case AT_MOST -> Relation.AT_LEAST;
      case GREATER -> Relation.LESS;
      case AT_LEAST -> Relation.AT_MOST;
    };
  }

  private static Relation opposite(Relation relation) {
    return switch (relation) {
      case EQUAL -> Relation.EQUAL;
      case LESS -> Relation.AT_LEAST;
      case AT_MOST -> Relation.GREATER;
      case GREATER -> Relation.AT_MOST;
      case AT_LEAST -> Relation.LESS;
    };
  }

  private static boolean holds(Relation relation, double value, double number) {
    return switch (relation) {
      case EQUAL -> value == number;
      case LESS -> value < number;
      case AT_MOST -> value <= number;
      case GREATER -> value > number;
      case AT_LEAST -> value >= number;
    };
  }
}
