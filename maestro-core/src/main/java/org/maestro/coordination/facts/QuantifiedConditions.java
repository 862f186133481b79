package org.maestro.coordination.facts;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Truth;

/**
 * Conditions of a plan that speak of any individual, such as that a hand holds nothing: many facts
 * concern them, few change them.
 */
final class QuantifiedConditions {
  private final Map<Formula, Truth> truths = new LinkedHashMap<>();

  /**
   * @param conditions closed and spelled out; those that name all of their individuals are left out
   */
  QuantifiedConditions(List<Formula> conditions, Facts now) {
    Evaluation evaluation = new Evaluation(now);
    conditions.stream()
        .filter(QuantifiedConditions::hasQuantifier)
        .forEach(condition -> truths.put(condition, evaluation.truth(condition, Map.of())));
  }

  private static boolean hasQuantifier(Formula formula) {
    return formula instanceof Formula.Exists
        || formula instanceof Formula.Forall
        || formula.parts().stream().anyMatch(QuantifiedConditions::hasQuantifier);
  }

  /** Whether one of them is true now and was not, or the other way round, when last asked. */
  boolean haveChanged(Facts now) {
    Evaluation evaluation = new Evaluation(now);
    boolean changed = false;
    for (Map.Entry<Formula, Truth> condition : truths.entrySet()) {
      Truth truth = evaluation.truth(condition.getKey(), Map.of());
      changed |= condition.setValue(truth) != truth;
    }
    return changed;
  }
}
