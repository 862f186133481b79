package org.maestro.planning;

import java.util.List;
import java.util.Set;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;

/**
 * What is to be planned.
 *
 * @param facts what is known now; immutable while planning
 * @param goal free variables are existential, and bound in the plan
 * @param barred steps that their member declined, or that failed twice with unchanged facts: not to
 *     be used
 */
public record PlanningTask(
    Vocabulary vocabulary,
    Facts facts,
    List<PricedFeature> features,
    Formula goal,
    Set<StepKey> barred) {

  PlanningTask withFeatures(List<PricedFeature> others) {
    return new PlanningTask(vocabulary, facts, others, goal, barred);
  }
}
