package org.maestro.coordination.achievement;

import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.maestro.coordination.facts.Sensing;
import org.maestro.planning.api.Step;
import org.maestro.sl.EffectTarget;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;

/**
 * A look that a plan has after a step that changes what is looked at: one that was begun before
 * that step shows what was so then, whenever it answers.
 */
final class PrematureLook {
  private PrematureLook() {}

  static boolean isIn(List<Step> plan, Step look) {
    if (!Sensing.isIn(look.feature().effect())) {
      return false;
    }
    Set<Formula.Atom> looked = targets(look);
    return plan.subList(0, plan.indexOf(look)).stream()
        .filter(step -> !Sensing.isAll(step.feature().effect()))
        .anyMatch(step -> targets(step).stream().anyMatch(looked::contains));
  }

  private static Set<Formula.Atom> targets(Step step) {
    Substitution substitution = new Substitution(step.values());
    Set<Formula.Atom> targets = new HashSet<>();
    for (EffectTarget target : EffectTarget.of(step.feature().effect())) {
      targets.add(substitution.apply(new Formula.Atom(target.name(), target.arguments())));
    }
    return targets;
  }
}
