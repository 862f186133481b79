package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Effect;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;

/** The sensing in a feature's effect: what it finds out. */
public final class Sensing {

  private Sensing() {}

  public static boolean isIn(Effect effect) {
    return any(effect, e -> e instanceof Effect.SenseAtom || e instanceof Effect.SenseNumber);
  }

  /** Whether it changes nothing. */
  public static boolean isAll(Effect effect) {
    return !any(
        effect, e -> !(e instanceof Effect.SenseAtom) && !(e instanceof Effect.SenseNumber));
  }

  public static boolean isOfAtoms(Effect effect) {
    return any(effect, Effect.SenseAtom.class::isInstance);
  }

  /** Names of the predicates and numbers that it senses. */
  public static Set<String> names(Effect effect) {
    Set<String> names = new TreeSet<>();
    any(
        effect,
        part -> {
          if (part instanceof Effect.SenseAtom sense) {
            names.add(sense.atom().predicate());
          } else if (part instanceof Effect.SenseNumber sense) {
            names.add(sense.fluent().name());
          }
          return false;
        });
    return names;
  }

  /** The atoms that it seeks: of what is at one place at a time, where that is. */
  public static List<Formula.Atom> sought(Effect effect, Vocabulary vocabulary) {
    List<Formula.Atom> atoms = new ArrayList<>();
    collect(effect, atoms);
    atoms.removeIf(
        atom ->
            atom.arguments().size() != 2
                || vocabulary
                    .predicate(atom.predicate())
                    .filter(PredicateDeclaration::functional)
                    .isEmpty());
    return atoms;
  }

  /** Whether a feature does not put things where they are sought. */
  public static boolean helpsToLook(FeatureType feature, Formula.Atom sought) {
    return !any(
        feature.effect(),
        part ->
            part instanceof Effect.Add add
                && add.atom().predicate().equals(sought.predicate())
                && !add.atom().arguments().get(0).equals(Self.VARIABLE));
  }

  private static void collect(Effect effect, List<Formula.Atom> atoms) {
    if (effect instanceof Effect.All all) {
      all.effects().forEach(part -> collect(part, atoms));
    } else if (effect instanceof Effect.When when) {
      collect(when.effect(), atoms);
    } else if (effect instanceof Effect.SenseAtom sense) {
      atoms.add(sense.atom());
    }
  }

  /** Whether any simple part of it is wanted; looks at none after that. */
  public static boolean any(Effect effect, Predicate<Effect> wanted) {
    if (effect instanceof Effect.All all) {
      return all.effects().stream().anyMatch(part -> any(part, wanted));
    } else if (effect instanceof Effect.When when) {
      return any(when.effect(), wanted);
    } else if (effect instanceof Effect.Forall forall) {
      return any(forall.effect(), wanted);
    }
    return wanted.test(effect);
  }
}
