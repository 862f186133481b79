package org.maestro.coordination;

import java.util.Set;
import java.util.TreeSet;
import java.util.function.Predicate;
import org.maestro.sl.Effect;

/** What a feature's effect finds out. */
final class Sensing {

  private Sensing() {}

  static boolean isIn(Effect effect) {
    return any(effect, e -> e instanceof Effect.SenseAtom || e instanceof Effect.SenseNumber);
  }

  static boolean isOfAtoms(Effect effect) {
    return any(effect, Effect.SenseAtom.class::isInstance);
  }

  /** Names of the predicates and numbers that it senses. */
  static Set<String> names(Effect effect) {
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

  private static boolean any(Effect effect, Predicate<Effect> wanted) {
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
