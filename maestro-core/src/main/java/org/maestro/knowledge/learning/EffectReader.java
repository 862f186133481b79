package org.maestro.knowledge.learning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Function;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Effect;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;
import org.maestro.sl.TypedVariable;

/**
 * Reads an effect as ground facts. Other than the planner it lives with two moments: conditions and
 * amounts are read before the step, while an increase is added to what is known now, since other
 * steps may have ended meanwhile. A part that mentions an output which the result does not have is
 * left out.
 */
final class EffectReader {

  private final Snapshot before;
  private final Function<Expression.Fluent, OptionalDouble> base;
  private final Evaluation evaluation;
  private final Map<Formula.Atom, Boolean> truths = new LinkedHashMap<>();
  private final Map<Expression.Fluent, OptionalDouble> numbers = new LinkedHashMap<>();
  private final boolean possibly;

  private EffectReader(
      Snapshot before, Function<Expression.Fluent, OptionalDouble> base, boolean possibly) {
    this.before = before;
    this.base = base;
    this.possibly = possibly;
    this.evaluation = new Evaluation(before);
  }

  /**
   * What the effect makes of the world: first what ceases to hold, then what begins to, then
   * numbers.
   *
   * @param base what an increase adds to
   */
  static List<Fact> facts(
      Effect effect,
      Map<String, Term> bindings,
      Snapshot before,
      Function<Expression.Fluent, OptionalDouble> base) {
    EffectReader reader = new EffectReader(before, base, false);
    reader.read(effect, bindings);
    List<Fact> facts = new ArrayList<>();
    reader.truths.forEach((atom, truth) -> addIf(!truth, facts, new Fact.Excluded(atom)));
    reader.truths.forEach((atom, truth) -> addIf(truth, facts, new Fact.Holds(atom)));
    reader.numbers.forEach(
        (fluent, value) ->
            facts.add(
                value.isPresent()
                    ? new Fact.Equation(fluent, new Term.Number(value.getAsDouble()))
                    : new Fact.Unknown(new Formula.Atom(fluent.name(), fluent.arguments()))));
    return facts;
  }

  /**
   * What the effect may have changed when nobody knows how far it came; fluents are written as
   * atoms.
   */
  static Set<Formula.Atom> touched(Effect effect, Map<String, Term> bindings, Snapshot before) {
    EffectReader reader = new EffectReader(before, before::number, true);
    reader.read(effect, bindings);
    Set<Formula.Atom> touched = new LinkedHashSet<>(reader.truths.keySet());
    reader.numbers.keySet().forEach(f -> touched.add(new Formula.Atom(f.name(), f.arguments())));
    return touched;
  }

  private static void addIf(boolean condition, List<Fact> facts, Fact fact) {
    if (condition) {
      facts.add(fact);
    }
  }

  private void read(Effect effect, Map<String, Term> bindings) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> read(part, bindings));
    } else if (effect instanceof Effect.When when) {
      if (mayHold(when.condition(), bindings)) {
        read(when.effect(), bindings);
      }
    } else if (effect instanceof Effect.Forall forall) {
      readAll(forall.variables(), forall.effect(), bindings);
    } else if (bindings.keySet().containsAll(FreeVariables.of(effect))) {
      readLeaf(effect, bindings);
    }
  }

  private void readLeaf(Effect effect, Map<String, Term> bindings) {
    Substitution substitution = new Substitution(bindings);
    if (effect instanceof Effect.Add add) {
      truths.put(substitution.apply(add.atom()), true);
    } else if (effect instanceof Effect.Delete delete) {
      truths.putIfAbsent(substitution.apply(delete.atom()), false);
    } else if (effect instanceof Effect.Change change) {
      Expression.Fluent fluent = substitution.apply(change.fluent());
      numbers.put(fluent, changed(change, fluent, evaluation.number(change.value(), bindings)));
    }
  }

  private OptionalDouble changed(
      Effect.Change change, Expression.Fluent fluent, OptionalDouble amount) {
    if (change.assignment() == Effect.Assignment.ASSIGN || amount.isEmpty()) {
      return amount;
    }
    OptionalDouble value = numbers.containsKey(fluent) ? numbers.get(fluent) : base.apply(fluent);
    double sign = change.assignment() == Effect.Assignment.INCREASE ? 1 : -1;
    return value.isEmpty()
        ? value
        : OptionalDouble.of(value.getAsDouble() + sign * amount.getAsDouble());
  }

  private void readAll(List<TypedVariable> variables, Effect effect, Map<String, Term> bindings) {
    if (variables.isEmpty()) {
      read(effect, bindings);
      return;
    }
    TypedVariable first = variables.get(0);
    for (Term.Name individual : before.individuals(first.className().orElse(""))) {
      Map<String, Term> extended = new LinkedHashMap<>(bindings);
      extended.put(first.name(), individual);
      readAll(variables.subList(1, variables.size()), effect, extended);
    }
  }

  private boolean mayHold(Formula condition, Map<String, Term> bindings) {
    if (!bindings.keySet().containsAll(FreeVariables.of(condition))) {
      return false;
    }
    Truth truth = evaluation.truth(condition, bindings);
    return truth == Truth.TRUE || possibly && truth == Truth.UNKNOWN;
  }
}
