package org.maestro.planning.search;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import org.maestro.planning.ground.GroundOperator;

/**
 * The operators among those objects that a relaxed plan from the initial state names: of a thousand
 * devices a plan needs few, and these are good ones to begin with.
 */
final class AmongThose {
  private AmongThose() {}

  /** All operators if there is no relaxed plan, or if operators name no objects. */
  static List<GroundOperator> of(RelaxedPlan relaxed, SearchTask task) {
    if (relaxed.estimate(task.initial) >= RelaxedPlan.INFINITE) {
      return task.operators;
    }
    BitSet named = new BitSet();
    for (int operator : relaxed.operators()) {
      GroundOperator used = task.operators.get(operator);
      if (namesObjects(used)) {
        Arrays.stream(used.arguments()).forEach(named::set);
      }
    }
    return task.operators.stream()
        .filter(o -> !namesObjects(o) || Arrays.stream(o.arguments()).allMatch(named::get))
        .toList();
  }

  /** Those that settle sums have numbers of another kind. */
  private static boolean namesObjects(GroundOperator operator) {
    return operator.schema() >= 0;
  }
}
