package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;

/** The changes that could make another plan necessary, or end a goal. */
public final class ReplanTriggers {
  private final FactFilter goal;
  private final FactFilter conditions;
  private final FactFilter effects;
  private final QuantifiedConditions quantified;

  public ReplanTriggers(Formula goal, List<Step> steps, Vocabulary vocabulary, Facts now) {
    this.goal = new FactFilter(vocabulary);
    this.goal.add(goal, Map.of());
    this.conditions = new FactFilter(vocabulary);
    this.effects = new FactFilter(vocabulary);
    Unfolding unfolding = new Unfolding(vocabulary);
    List<Formula> closed = new ArrayList<>();
    for (Step step : steps) {
      conditions.addConditions(step);
      effects.addEffects(step);
      unfolding.conjuncts(step.feature().precondition(), step.values()).stream()
          .filter(condition -> FreeVariables.of(condition).isEmpty())
          .forEach(closed::add);
    }
    this.quantified = new QuantifiedConditions(closed, now);
  }

  /** The goal itself may be reached, or no more so. */
  public boolean ofGoal(FactFilter changed) {
    return goal.isConcernedBy(changed);
  }

  /** The goal or its plan may be touched, for all that the names say. */
  public boolean perhaps(FactFilter changed) {
    return ofGoal(changed) || conditions.isConcernedBy(changed) || effects.isConcernedBy(changed);
  }

  /** The same, but what holds of any individual is looked at. */
  public boolean indeed(FactFilter changed, Facts now) {
    return ofGoal(changed)
        || effects.isConcernedBy(changed)
        || conditions.isNamedBy(changed)
        || conditions.isConcernedBy(changed) && quantified.haveChanged(now);
  }
}
