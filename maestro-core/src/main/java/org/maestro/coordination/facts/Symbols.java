package org.maestro.coordination.facts;

import java.util.Set;
import java.util.TreeSet;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.Leaves;

/** The names of the predicates and fluents that formulas and effects speak of. */
public final class Symbols {
  private final Set<String> names = new TreeSet<>();

  public static Set<String> of(Formula formula) {
    Symbols symbols = new Symbols();
    symbols.add(formula);
    return symbols.names;
  }

  /** What a formula speaks of, and what that is derived from. */
  public static Set<String> withDerivations(Formula formula, Vocabulary vocabulary) {
    Set<String> all = new TreeSet<>();
    addDerivations(of(formula), vocabulary, all);
    return all;
  }

  private static void addDerivations(Set<String> names, Vocabulary vocabulary, Set<String> all) {
    for (String name : names) {
      if (all.add(name)) {
        vocabulary
            .predicate(name)
            .flatMap(PredicateDeclaration::derivedWhen)
            .ifPresent(when -> addDerivations(of(when), vocabulary, all));
      }
    }
  }

  /** What an effect may change or sense. */
  public static Set<String> changedBy(Effect effect) {
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
    Leaves.of(formula, atom -> names.add(atom.predicate()), fluent -> names.add(fluent.name()));
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
      Leaves.of(change.value(), fluent -> names.add(fluent.name()));
    }
  }
}
