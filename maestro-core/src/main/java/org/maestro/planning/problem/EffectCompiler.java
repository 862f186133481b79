package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Term;

/**
 * Makes ground changes of effects. Changes that can never happen are left out. What a part of an
 * effect changes is the same for all steps that bind its own variables alike, and made once.
 */
public final class EffectCompiler {
  private final ConditionCompiler conditions;
  private final Variables variables;
  private final IdentityHashMap<Effect, Part> parts = new IdentityHashMap<>();

  /** A part of an effect, with what it changes by the values of its variables. */
  private record Part(List<String> variables, Map<List<Term>, List<Change>> changes) {}

  public EffectCompiler(ConditionCompiler conditions, Variables variables) {
    this.conditions = conditions;
    this.variables = variables;
  }

  public List<Change> changes(Effect effect, Map<String, Term> bindings) {
    if (!(effect instanceof Effect.All all)) {
      return ofPart(effect, bindings);
    }
    return JoinedChanges.of(all.effects().stream().map(part -> ofPart(part, bindings)).toList());
  }

  private List<Change> ofPart(Effect effect, Map<String, Term> bindings) {
    Part part =
        parts.computeIfAbsent(
            effect, absent -> new Part(List.copyOf(FreeVariables.of(effect)), new HashMap<>()));
    List<Term> values = new ArrayList<>(part.variables().size());
    part.variables().forEach(name -> values.add(bindings.get(name)));
    List<Change> known = part.changes().get(values);
    if (known == null) {
      List<Change> changes = new ArrayList<>();
      collect(effect, bindings, Constant.TRUE, changes);
      known = List.copyOf(changes);
      part.changes().put(values, known);
    }
    return known;
  }

  /** What cannot be changed may be otherwise from now on. */
  public void forget() {
    parts.clear();
  }

  private void collect(
      Effect effect, Map<String, Term> bindings, Condition condition, List<Change> changes) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, bindings, condition, changes));
    } else if (effect instanceof Effect.When when) {
      Condition inner = conditions.condition(when.condition(), bindings);
      Condition both = Condition.all(List.of(condition, inner));
      if (both != Constant.FALSE) {
        collect(when.effect(), bindings, both, changes);
      }
    } else if (effect instanceof Effect.Forall forall) {
      conditions.forEachGrounding(
          forall.variables(),
          forall.effect() instanceof Effect.When when
              ? Optional.of(when.condition())
              : Optional.empty(),
          bindings,
          extended -> collect(forall.effect(), extended, condition, changes));
    } else if (effect instanceof Effect.Add add) {
      Formula.Atom atom = ConditionCompiler.ground(add.atom(), bindings);
      Variable variable = variables.variable(atom);
      changes.add(new Change.Put(condition, variable, variables.value(atom, variable)));
    } else if (effect instanceof Effect.Delete delete) {
      Formula.Atom atom = ConditionCompiler.ground(delete.atom(), bindings);
      Variable variable = variables.variable(atom);
      changes.add(new Change.Remove(condition, variable, variables.value(atom, variable)));
    } else if (effect instanceof Effect.SenseAtom sense) {
      Formula.Atom atom = ConditionCompiler.ground(sense.atom(), bindings);
      Variable variable = variables.variable(atom);
      if (variable.observable()) {
        changes.add(new Change.Find(condition, variable, variables.value(atom, variable)));
      }
    } else if (effect instanceof Effect.SenseNumber sense) {
      NumberVariable number = variables.number(ConditionCompiler.ground(sense.fluent(), bindings));
      changes.add(new Change.Measure(condition, number));
    } else if (effect instanceof Effect.Change change) {
      NumberVariable number = variables.number(ConditionCompiler.ground(change.fluent(), bindings));
      NumberExpression value = conditions.number(change.value(), bindings);
      changes.add(new Change.Adjust(condition, number, change.assignment(), value));
    }
  }
}
