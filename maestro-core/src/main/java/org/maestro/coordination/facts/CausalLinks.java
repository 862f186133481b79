package org.maestro.coordination.facts;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.ontology.vocabulary.Vocabulary;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The protected conditions of a goal, which have to stay so: those of steps that it has yet to do
 * or is doing, and those parts of the goal that it has brought about already. Only what is so now
 * counts.
 */
public final class CausalLinks {
  private final Vocabulary vocabulary;
  private final Unfolding unfolding;
  private final List<Condition> conditions = new ArrayList<>();

  private record Condition(Formula formula, FactFilter subjects) {}

  public CausalLinks(Vocabulary vocabulary) {
    this.vocabulary = vocabulary;
    this.unfolding = new Unfolding(vocabulary);
  }

  /** What the step needs to begin, and while it runs. */
  public void addConditions(Step step) {
    conditions(step).forEach(this::add);
  }

  /** That of it which depends on what was brought about. */
  public void addAchievedConditions(Step step, FactFilter broughtAbout) {
    conditions(step).forEach(formula -> addIfConcerned(formula, broughtAbout));
  }

  private List<Formula> conditions(Step step) {
    return unfolding.conjuncts(step.feature().precondition(), step.values()).stream()
        .filter(formula -> !mentionsUnknown(formula))
        .toList();
  }

  /** The parts of the goal that depend on what was brought about. */
  public void addAchieved(Formula goal, Map<String, Term> binding, FactFilter broughtAbout) {
    unfolding.conjuncts(goal, binding).forEach(formula -> addIfConcerned(formula, broughtAbout));
  }

  private void addIfConcerned(Formula formula, FactFilter broughtAbout) {
    FactFilter subjects = subjects(formula);
    if (subjects.isConcernedBy(broughtAbout)) {
      conditions.add(new Condition(formula, subjects));
    }
  }

  /** Every part of the goal. */
  public void addAll(Formula goal, Map<String, Term> binding) {
    unfolding.conjuncts(goal, binding).forEach(this::add);
  }

  private void add(Formula formula) {
    conditions.add(new Condition(formula, subjects(formula)));
  }

  private FactFilter subjects(Formula formula) {
    FactFilter subjects = new FactFilter(vocabulary);
    subjects.add(formula, Map.of());
    return subjects;
  }

  /** That something is not known is no fact that anybody could spoil by finding it out. */
  private static boolean mentionsUnknown(Formula formula) {
    return formula instanceof Formula.UnknownAtom
        || formula instanceof Formula.UnknownNumber
        || formula.parts().stream().anyMatch(CausalLinks::mentionsUnknown);
  }

  /** The first condition that is so now, and would not be after the changes. */
  public Optional<Formula> brokenBy(List<Change> changes, Facts now) {
    if (changes.isEmpty() || conditions.isEmpty()) {
      return Optional.empty();
    }
    FactFilter changed = FactFilter.ofChanges(changes, vocabulary);
    Evaluation before = new Evaluation(now);
    Evaluation after = new Evaluation(new ProgressedState(now, changes, vocabulary));
    return conditions.stream()
        .filter(condition -> condition.subjects().isConcernedBy(changed))
        .map(Condition::formula)
        .filter(formula -> FreeVariables.of(formula).isEmpty())
        .filter(formula -> before.truth(formula, Map.of()) == Truth.TRUE)
        .filter(formula -> after.truth(formula, Map.of()) != Truth.TRUE)
        .findFirst();
  }
}
