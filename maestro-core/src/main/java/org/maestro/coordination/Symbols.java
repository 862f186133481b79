package org.maestro.coordination;

import java.util.Set;
import java.util.TreeSet;
import org.maestro.sl.Effect;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;

/** The names of the predicates and fluents that formulas and effects speak of. */
final class Symbols {
  private final Set<String> names = new TreeSet<>();

  static Set<String> of(Formula formula) {
    Symbols symbols = new Symbols();
    symbols.add(formula);
    return symbols.names;
  }

  /** What an effect may change or sense. */
  static Set<String> changedBy(Effect effect) {
    Symbols symbols = new Symbols();
    symbols.addChanged(effect);
    return symbols.names;
  }

  /** What an effect's conditions and values depend on. */
  static Set<String> readBy(Effect effect) {
    Symbols symbols = new Symbols();
    symbols.addRead(effect);
    return symbols.names;
  }

  private void add(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      names.add(atom.predicate());
    } else if (formula instanceof Formula.And and) {
      and.operands().forEach(this::add);
    } else if (formula instanceof Formula.Or or) {
      or.operands().forEach(this::add);
    } else if (formula instanceof Formula.Not not) {
      add(not.operand());
    } else if (formula instanceof Formula.Imply imply) {
      add(imply.premise());
      add(imply.conclusion());
    } else if (formula instanceof Formula.Exists exists) {
      add(exists.body());
    } else if (formula instanceof Formula.Forall forall) {
      add(forall.body());
    } else if (formula instanceof Formula.Comparison comparison) {
      add(comparison.left());
      add(comparison.right());
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      names.add(unknown.atom().predicate());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      names.add(unknown.fluent().name());
    } else if (formula instanceof Formula.Keep keep) {
      add(keep.body());
    }
  }

  private void add(Expression expression) {
    if (expression instanceof Expression.Fluent fluent) {
      names.add(fluent.name());
    } else if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(this::add);
    }
  }

  private void addChanged(Effect effect) {
    if (effect instanceof Effect.Add add) {
      names.add(add.atom().predicate());
    } else if (effect instanceof Effect.Delete delete) {
      names.add(delete.atom().predicate());
    } else if (effect instanceof Effect.All all) {
      all.effects().forEach(this::addChanged);
    } else if (effect instanceof Effect.When when) {
      addChanged(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      addChanged(forall.effect());
    } else if (effect instanceof Effect.Change change) {
      names.add(change.fluent().name());
    } else if (effect instanceof Effect.SenseAtom sense) {
      names.add(sense.atom().predicate());
    } else if (effect instanceof Effect.SenseNumber sense) {
      names.add(sense.fluent().name());
    }
  }

  private void addRead(Effect effect) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(this::addRead);
    } else if (effect instanceof Effect.When when) {
      add(when.condition());
      addRead(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      addRead(forall.effect());
    } else if (effect instanceof Effect.Change change) {
      add(change.value());
    }
  }
}
