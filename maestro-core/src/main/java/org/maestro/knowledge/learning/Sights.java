package org.maestro.knowledge.learning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.knowledge.belief.Declarations;
import org.maestro.knowledge.belief.World;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Fact;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Self;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The observations of continuous features, which last no longer than the numbers that the features
 * need: a camera that had a thing in view does not see it any more when its zone is too dark,
 * whether it says so or not. Where a thing was seen stays known. Guarded by the writer's lock.
 */
public final class Sights {
  private final Map<StateVariable, Formula> needs = new LinkedHashMap<>();

  /**
   * Notes what the run let know, until the numbers that it needs are not enough any more. Who
   * succeeds though they seem not to be enough knows better.
   */
  public void note(FeatureRun run, List<Fact> facts, World world, Facts present) {
    if (!run.succeeded() || !run.feature().continuous()) {
      return;
    }
    List<Formula> comparisons = new ArrayList<>();
    collect(run.feature().precondition(), comparisons);
    if (comparisons.isEmpty()) {
      return;
    }
    Map<String, Term> bindings = Self.is(run.member(), run.bindings());
    Formula need = new Substitution(bindings).apply(new Formula.And(comparisons));
    boolean seemsEnough = new Evaluation(present).truth(need, Map.of()) != Truth.FALSE;
    for (Fact fact : facts) {
      if (fact instanceof Fact.Holds holds
          && !holds.atom().predicate().equals(Declarations.POSITION)) {
        StateVariable variable = world.declarations().spokenOf(fact);
        if (seemsEnough) {
          needs.put(variable, need);
        } else {
          needs.remove(variable);
        }
      }
    }
  }

  private static void collect(Formula formula, List<Formula> comparisons) {
    if (formula instanceof Formula.And and) {
      and.operands().forEach(part -> collect(part, comparisons));
    } else if (formula instanceof Formula.Comparison) {
      comparisons.add(formula);
    }
  }

  /** Those that last no longer. */
  public Set<StateVariable> ended(Facts present) {
    Set<StateVariable> ended = new LinkedHashSet<>();
    Evaluation evaluation = new Evaluation(present);
    needs.forEach(
        (variable, need) -> {
          if (evaluation.truth(need, Map.of()) == Truth.FALSE) {
            ended.add(variable);
          }
        });
    needs.keySet().removeAll(ended);
    return ended;
  }
}
