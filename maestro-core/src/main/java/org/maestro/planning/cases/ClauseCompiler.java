package org.maestro.planning.cases;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.NumberVector;
import org.maestro.planning.problem.Quantity;
import org.maestro.sl.Formula.Relation;
import org.maestro.sl.SlPrinter;

/** Writes conditions as alternatives of facts and bounds. */
public final class ClauseCompiler {
  private static final int MOST_CLAUSES = 2000;

  private final NumberRanges ranges;

  public ClauseCompiler(NumberRanges ranges) {
    this.ranges = ranges;
  }

  /**
   * The alternatives of which at least one holds whenever the condition does; none when it never
   * does.
   *
   * @throws NotCarriedException when there are too many, or sums are compared with each other
   */
  public List<Clause> clauses(Condition condition) {
    return clauses(condition, true);
  }

  /** The same for the condition's contrary. */
  List<Clause> contrary(Condition condition) {
    return clauses(condition, false);
  }

  private List<Clause> clauses(Condition condition, boolean positive) {
    if (condition instanceof Condition.All all) {
      return joined(all.parts(), positive, positive);
    } else if (condition instanceof Condition.Any any) {
      return joined(any.parts(), positive, !positive);
    } else if (condition instanceof Condition.Constant constant) {
      return (constant == Condition.Constant.TRUE) == positive ? List.of(Clause.EMPTY) : List.of();
    } else if (condition instanceof Condition.Literal literal) {
      return List.of(literal(literal, positive));
    } else if (condition instanceof Condition.NumberKnown known) {
      return known(known.variable(), known.known() == positive);
    } else if (condition instanceof Condition.Compare compare) {
      return compare(compare, positive);
    }
    return positive ? List.of() : List.of(Clause.EMPTY);
  }

  private List<Clause> joined(List<Condition> parts, boolean positive, boolean conjunction) {
    List<Clause> joined = conjunction ? List.of(Clause.EMPTY) : new ArrayList<>();
    for (Condition part : parts) {
      List<Clause> more = clauses(part, positive);
      if (conjunction) {
        joined = Clause.product(joined, more);
      } else {
        joined.addAll(more);
      }
      if (joined.size() > MOST_CLAUSES) {
        throw new NotCarriedException(
            "PDDL cannot carry a condition with more than %d alternatives."
                .formatted(MOST_CLAUSES));
      }
    }
    return joined.stream().distinct().toList();
  }

  private static Clause literal(Condition.Literal literal, boolean positive) {
    Clause.Is is = new Clause.Is(literal.variable(), literal.value());
    Clause.Open open = new Clause.Open(literal.variable(), literal.value());
    return switch (literal.question()) {
      case IS -> Clause.of(is, positive);
      case IS_NOT -> Clause.of(is, !positive);
      case UNKNOWN -> Clause.of(open, positive);
      case NOT_UNKNOWN -> Clause.of(open, !positive);
    };
  }

  private List<Clause> known(NumberVariable variable, boolean known) {
    if (ranges.isSum(variable)) {
      return known ? List.of(Clause.EMPTY) : List.of();
    }
    return List.of(Clause.of(new Clause.Has(variable, Quantity.UNKNOWN), !known));
  }

  private List<Clause> compare(Condition.Compare compare, boolean positive) {
    Set<NumberVariable> read = new LinkedHashSet<>();
    compare.left().forEachVariable(read::add);
    compare.right().forEachVariable(read::add);
    Optional<NumberVariable> sum = read.stream().filter(ranges::isSum).findFirst();
    if (sum.isPresent()) {
      return bounds(compare, positive, sum.get(), read.size() > 1);
    }
    List<Clause> clauses = new ArrayList<>();
    Clause[] none = {Clause.EMPTY};
    ranges.forEachChoice(
        read,
        numbers -> {
          boolean holds =
              compare.holdsFor(compare.left().value(numbers), compare.right().value(numbers));
          Clause clause = choice(read, numbers);
          if (holds == positive) {
            clauses.add(clause);
          } else if (read.size() == 1) {
            Clause.Fact other = clause.facts().keySet().iterator().next();
            none[0] = none[0].and(Clause.of(other, false)).orElseThrow();
          }
        });
    return read.size() == 1 && !clauses.isEmpty() ? List.of(none[0]) : clauses;
  }

  /** That some numbers have the values that they have among these. */
  static Clause choice(Set<NumberVariable> variables, NumberVector numbers) {
    Clause clause = Clause.EMPTY;
    for (NumberVariable variable : variables) {
      Clause.Has has = new Clause.Has(variable, numbers.get(variable.index()));
      clause = clause.and(Clause.of(has, true)).orElseThrow();
    }
    return clause;
  }

  /** A sum is always known, and the bound is a constant. */
  private static List<Clause> bounds(
      Condition.Compare compare, boolean positive, NumberVariable sum, boolean others) {
    boolean left = compare.left() instanceof NumberExpression.Read;
    NumberExpression constant = left ? compare.right() : compare.left();
    boolean plain = left || compare.right() instanceof NumberExpression.Read;
    if (others || !plain || !(constant instanceof NumberExpression.Constant bound)) {
      throw new NotCarriedException(
          "PDDL cannot carry a comparison of %s with what is not a constant."
              .formatted(SlPrinter.print(sum.fluent())));
    }
    boolean holds = compare.positive() == positive;
    double number = bound.number();
    if (Quantity.isUnknown(number)) {
      return holds ? List.of() : List.of(Clause.EMPTY);
    }
    List<String> relations = relations(compare.relation(), left, holds);
    return relations.stream()
        .map(relation -> new Clause(Map.of(), List.of(new Clause.Bound(sum, relation, number))))
        .toList();
  }

  private static List<String> relations(Relation relation, boolean sumIsLeft, boolean holds) {
    String symbol =
        switch (relation) {
          case EQUAL -> "=";
          case LESS -> holds ? "<" : ">=";
          case AT_MOST -> holds ? "<=" : ">";
          case GREATER -> holds ? ">" : "<=";
          case AT_LEAST -> holds ? ">=" : "<";
        };
    if (relation == Relation.EQUAL) {
      return holds ? List.of("=") : List.of("<", ">");
    }
    return List.of(
        sumIsLeft
            ? symbol
            : symbol.startsWith("<") ? symbol.replace('<', '>') : symbol.replace('>', '<'));
  }
}
