package org.maestro.sl;

import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.Predicate;

/**
 * Evaluates formulas, numbers and effects over facts, in Kleene's three-valued logic. A comparison
 * with an unknown number is unknown. Numbers within 1e-9 of each other count as equal. As safe for
 * threads as the facts are. A variable without a value is an {@link IllegalArgumentException}.
 */
public final class Evaluation {

  private static final double TOLERANCE = 1e-9;

  /** So many individuals are tried sooner than it is found out which of them can matter. */
  private static final int FEW = 4;

  private final Facts facts;
  private final Candidates candidates;

  public Evaluation(Facts facts) {
    this.facts = facts;
    this.candidates = new Candidates(facts::candidates);
  }

  /**
   * @param bindings values of the free variables, by name without question mark
   */
  public Truth truth(Formula formula, Map<String, Term> bindings) {
    if (formula instanceof Formula.Atom atom) {
      return facts.truth(ground(atom, bindings));
    } else if (formula instanceof Formula.And and) {
      return all(and.operands(), operand -> truth(operand, bindings));
    } else if (formula instanceof Formula.Or or) {
      return any(or.operands(), operand -> truth(operand, bindings));
    } else if (formula instanceof Formula.Not not) {
      return negated(truth(not.operand(), bindings));
    } else if (formula instanceof Formula.Imply imply) {
      Truth premise = truth(imply.premise(), bindings);
      return premise == Truth.FALSE
          ? Truth.TRUE
          : either(negated(premise), truth(imply.conclusion(), bindings));
    } else if (formula instanceof Formula.Exists exists) {
      return forSome(exists.variables(), exists.body(), true, bindings);
    } else if (formula instanceof Formula.Forall forall) {
      return negated(forSome(forall.variables(), forall.body(), false, bindings));
    } else if (formula instanceof Formula.Comparison comparison) {
      return compared(comparison, bindings);
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      return Truth.of(facts.truth(ground(unknown.atom(), bindings)) == Truth.UNKNOWN);
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      return Truth.of(number(unknown.fluent(), bindings).isEmpty());
    }
    // Of a goal that is bound to what is yet to come, nothing is known.
    return formula instanceof Formula.Keep keep ? truth(keep.body(), bindings) : Truth.UNKNOWN;
  }

  /**
   * The expression's number; empty when a fluent in it is unknown, a variable is bound to no number
   * (NaN), or it divides by zero.
   */
  public OptionalDouble number(Expression expression, Map<String, Term> bindings) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      Term term = ground(ofTerm.term(), bindings);
      return term instanceof Term.Number number && !Double.isNaN(number.value())
          ? OptionalDouble.of(number.value())
          : OptionalDouble.empty();
    } else if (expression instanceof Expression.Fluent fluent) {
      return facts.number(ground(fluent, bindings));
    }
    Expression.Arithmetic arithmetic = (Expression.Arithmetic) expression;
    double[] values = new double[arithmetic.operands().size()];
    for (int i = 0; i < values.length; i++) {
      OptionalDouble value = number(arithmetic.operands().get(i), bindings);
      if (value.isEmpty()) {
        return value;
      }
      values[i] = value.getAsDouble();
    }
    double result = arithmetic.operator().apply(values);
    return Double.isFinite(result) ? OptionalDouble.of(result) : OptionalDouble.empty();
  }

  /**
   * What the effect changes, first what ceases to hold, then what begins to, then numbers. All
   * values are read from the facts before any change. An effect under an unknown condition is not
   * made; {@code sense} changes nothing.
   */
  public List<Change> changes(Effect effect, Map<String, Term> bindings) {
    Map<Formula.Atom, Boolean> truths = new LinkedHashMap<>();
    Map<Expression.Fluent, OptionalDouble> numbers = new LinkedHashMap<>();
    collect(effect, bindings, truths, numbers);
    List<Change> changes = new ArrayList<>();
    for (boolean value : new boolean[] {false, true}) {
      truths.forEach(
          (atom, held) -> {
            if (held == value) {
              changes.add(new Change.OfTruth(atom, held));
            }
          });
    }
    numbers.forEach((fluent, value) -> changes.add(new Change.OfNumber(fluent, value)));
    return List.copyOf(changes);
  }

  private void collect(
      Effect effect,
      Map<String, Term> bindings,
      Map<Formula.Atom, Boolean> truths,
      Map<Expression.Fluent, OptionalDouble> numbers) {
    if (effect instanceof Effect.Add add) {
      truths.put(ground(add.atom(), bindings), true);
    } else if (effect instanceof Effect.Delete delete) {
      truths.putIfAbsent(ground(delete.atom(), bindings), false);
    } else if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, bindings, truths, numbers));
    } else if (effect instanceof Effect.When when) {
      if (truth(when.condition(), bindings) == Truth.TRUE) {
        collect(when.effect(), bindings, truths, numbers);
      }
    } else if (effect instanceof Effect.Forall forall) {
      choose(
          forall.variables(),
          new HashMap<>(bindings),
          (variable, others) -> Optional.empty(),
          extended -> {
            collect(forall.effect(), extended, truths, numbers);
            return true;
          });
    } else if (effect instanceof Effect.Change change) {
      Expression.Fluent fluent = ground(change.fluent(), bindings);
      OptionalDouble before = numbers.getOrDefault(fluent, facts.number(fluent));
      OptionalDouble value = number(change.value(), bindings);
      numbers.put(fluent, changed(change.assignment(), before, value));
    }
  }

  private static OptionalDouble changed(
      Effect.Assignment assignment, OptionalDouble before, OptionalDouble value) {
    if (assignment == Effect.Assignment.ASSIGN || value.isEmpty()) {
      return value;
    }
    double sign = assignment == Effect.Assignment.INCREASE ? 1 : -1;
    return before.isEmpty()
        ? before
        : OptionalDouble.of(before.getAsDouble() + sign * value.getAsDouble());
  }

  private Truth compared(Formula.Comparison comparison, Map<String, Term> bindings) {
    if (isOther(comparison.left(), bindings) || isOther(comparison.right(), bindings)) {
      return Truth.of(
          comparison.left() instanceof Expression.OfTerm left
              && comparison.right() instanceof Expression.OfTerm right
              && comparison.relation() == Formula.Relation.EQUAL
              && ground(left.term(), bindings).equals(ground(right.term(), bindings)));
    }
    OptionalDouble left = number(comparison.left(), bindings);
    OptionalDouble right = number(comparison.right(), bindings);
    if (left.isEmpty() || right.isEmpty()) {
      return Truth.UNKNOWN;
    }
    double difference = left.getAsDouble() - right.getAsDouble();
    return Truth.of(
        switch (comparison.relation()) {
          case EQUAL -> Math.abs(difference) <= TOLERANCE;
          case LESS -> difference < -TOLERANCE;
          case AT_MOST -> difference <= TOLERANCE;
          case GREATER -> difference > TOLERANCE;
          case AT_LEAST -> difference >= -TOLERANCE;
        });
  }

  /** Whether it is a term that is no number. */
  private static boolean isOther(Expression expression, Map<String, Term> bindings) {
    return expression instanceof Expression.OfTerm ofTerm
        && !(ground(ofTerm.term(), bindings) instanceof Term.Number);
  }

  /**
   * Whether the body is so for some choice of individuals.
   *
   * @param holding whether it is to hold; otherwise it is not to
   */
  private Truth forSome(
      List<TypedVariable> variables, Formula body, boolean holding, Map<String, Term> bindings) {
    Truth[] result = {Truth.FALSE};
    choose(
        variables,
        new HashMap<>(bindings),
        (variable, others) -> candidates.of(body, holding, variable, others),
        extended -> {
          Truth truth = truth(body, extended);
          result[0] = either(result[0], holding ? truth : negated(truth));
          return result[0] != Truth.TRUE;
        });
    return result[0];
  }

  /**
   * Hands on every choice of individuals for the variables, as long as more are wanted. They are
   * made in the one map, which is as it was afterwards.
   *
   * @param narrowing those who may stand for a variable, by the values of those before it
   * @return whether more are wanted
   */
  private boolean choose(
      List<TypedVariable> variables,
      Map<String, Term> bindings,
      BiFunction<String, Map<String, Term>, Optional<Set<Term>>> narrowing,
      Predicate<Map<String, Term>> visitor) {
    if (variables.isEmpty()) {
      return visitor.test(bindings);
    }
    TypedVariable variable = variables.get(0);
    Optional<Term> outside = Optional.ofNullable(bindings.get(variable.name()));
    Collection<Term.Name> individuals = facts.individuals(variable.className().orElse(""));
    Optional<Set<Term>> among = Optional.empty();
    if (individuals.size() > FEW) {
      Map<String, Term> others = new HashMap<>(bindings);
      variables.forEach(open -> others.remove(open.name()));
      among = narrowing.apply(variable.name(), others);
    }
    boolean more = true;
    for (Term.Name individual : individuals) {
      if (among.isPresent() && !among.get().contains(individual)) {
        continue;
      }
      bindings.put(variable.name(), individual);
      more = choose(variables.subList(1, variables.size()), bindings, narrowing, visitor);
      if (!more) {
        break;
      }
    }
    outside.ifPresentOrElse(
        term -> bindings.put(variable.name(), term), () -> bindings.remove(variable.name()));
    return more;
  }

  private static <T> Truth any(List<T> parts, Function<T, Truth> truth) {
    Truth result = Truth.FALSE;
    for (T part : parts) {
      result = either(result, truth.apply(part));
      if (result == Truth.TRUE) {
        return result;
      }
    }
    return result;
  }

  private static <T> Truth all(List<T> parts, Function<T, Truth> truth) {
    return negated(any(parts, part -> negated(truth.apply(part))));
  }

  private static Truth either(Truth left, Truth right) {
    if (left == Truth.TRUE || right == Truth.TRUE) {
      return Truth.TRUE;
    }
    return left == Truth.UNKNOWN || right == Truth.UNKNOWN ? Truth.UNKNOWN : Truth.FALSE;
  }

  private static Truth negated(Truth truth) {
    return switch (truth) {
      case TRUE -> Truth.FALSE;
      case FALSE -> Truth.TRUE;
      case UNKNOWN -> Truth.UNKNOWN;
    };
  }

  private static Formula.Atom ground(Formula.Atom atom, Map<String, Term> bindings) {
    return new Formula.Atom(atom.predicate(), ground(atom.arguments(), bindings));
  }

  private static Expression.Fluent ground(Expression.Fluent fluent, Map<String, Term> bindings) {
    return new Expression.Fluent(fluent.name(), ground(fluent.arguments(), bindings));
  }

  private static List<Term> ground(List<Term> terms, Map<String, Term> bindings) {
    return terms.stream().map(term -> ground(term, bindings)).toList();
  }

  private static Term ground(Term term, Map<String, Term> bindings) {
    if (!(term instanceof Term.Variable variable)) {
      return term;
    }
    Term value = bindings.get(variable.name());
    if (value == null) {
      throw new IllegalArgumentException(
          "The variable ?" + variable.name() + " has no value; bind it or quantify over it.");
    }
    return value;
  }
}
