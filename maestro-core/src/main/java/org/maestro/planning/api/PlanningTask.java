package org.maestro.planning.api;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;

/**
 * The planning problem: known facts, features with their prices, and the goal.
 *
 * @param facts what is known now; immutable while planning
 * @param goal free variables are existential, and bound in the plan
 * @param barred steps that their member declined, or that failed twice with unchanged facts: not to
 *     be used
 * @param objective what the plan is to be best in
 * @param unavailable what nobody can count on now; only explanations look at it
 * @param whyBarred reasons for barred steps, where known; only explanations look at them
 */
public record PlanningTask(
    Vocabulary vocabulary,
    Facts facts,
    List<PricedFeature> features,
    Formula goal,
    Set<StepKey> barred,
    Objective objective,
    List<Unavailable> unavailable,
    Map<StepKey, String> whyBarred) {

  /** A task for the cheapest plan, with nothing known of what is missing. */
  public PlanningTask(
      Vocabulary vocabulary,
      Facts facts,
      List<PricedFeature> features,
      Formula goal,
      Set<StepKey> barred) {
    this(vocabulary, facts, features, goal, barred, Objective.CHEAPEST, List.of(), Map.of());
  }

  public PlanningTask withFeatures(List<PricedFeature> others) {
    return new PlanningTask(
        vocabulary, facts, others, goal, barred, objective, unavailable, whyBarred);
  }

  public PlanningTask withFacts(Facts others) {
    return new PlanningTask(
        vocabulary, others, features, goal, barred, objective, unavailable, whyBarred);
  }

  public PlanningTask withBarred(Set<StepKey> others) {
    return new PlanningTask(
        vocabulary, facts, features, goal, others, objective, unavailable, whyBarred);
  }

  public PlanningTask withObjective(Objective other) {
    return new PlanningTask(
        vocabulary, facts, features, goal, barred, other, unavailable, whyBarred);
  }

  public PlanningTask withUnavailable(List<Unavailable> others, Map<StepKey, String> reasons) {
    return new PlanningTask(vocabulary, facts, features, goal, barred, objective, others, reasons);
  }
}
