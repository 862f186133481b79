package org.maestro.sl;

import java.util.ArrayList;
import java.util.List;

/** A predicate or number that a part of an effect names, with its arguments, the value included. */
public record EffectTarget(String name, List<Term> arguments) {

  /** In the order in which they stand in the effect. */
  public static List<EffectTarget> of(Effect effect) {
    List<EffectTarget> targets = new ArrayList<>();
    collect(effect, targets);
    return targets;
  }

  private static void collect(Effect effect, List<EffectTarget> targets) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, targets));
    } else if (effect instanceof Effect.When when) {
      collect(when.effect(), targets);
    } else if (effect instanceof Effect.Forall forall) {
      collect(forall.effect(), targets);
    } else if (effect instanceof Effect.Add add) {
      targets.add(of(add.atom()));
    } else if (effect instanceof Effect.Delete delete) {
      targets.add(of(delete.atom()));
    } else if (effect instanceof Effect.SenseAtom sense) {
      targets.add(of(sense.atom()));
    } else if (effect instanceof Effect.SenseNumber sense) {
      targets.add(of(sense.fluent()));
    } else if (effect instanceof Effect.Change change) {
      targets.add(of(change.fluent()));
    }
  }

  private static EffectTarget of(Formula.Atom atom) {
    return new EffectTarget(atom.predicate(), atom.arguments());
  }

  private static EffectTarget of(Expression.Fluent fluent) {
    return new EffectTarget(fluent.name(), fluent.arguments());
  }
}
