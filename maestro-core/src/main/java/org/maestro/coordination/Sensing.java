package org.maestro.coordination;

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

  private static boolean any(Effect effect, Predicate<Effect> wanted) {
    return effect instanceof Effect.All all
        ? all.effects().stream().anyMatch(part -> any(part, wanted))
        : wanted.test(effect);
  }
}
