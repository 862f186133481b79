package org.maestro.coordination;

import java.util.Collection;
import java.util.List;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.vocabulary.NameCheck;
import org.maestro.ontology.vocabulary.Nearest;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.Term;

/**
 * Refuses goals that speak of what neither home nor vocabulary know, before anybody is asked for
 * anything.
 */
public final class GoalCheck {
  private final Home home;

  /** For goals in this home. */
  public GoalCheck(Home home) {
    this.home = home;
  }

  /**
   * Looks at every word of a goal.
   *
   * @throws InvalidGoalException for the first that is wrong
   */
  public void check(Formula goal) {
    Leaves.of(goal, atom -> checkNames(atom.arguments()), fluent -> checkNames(fluent.arguments()));
    new NameCheck(
            home.vocabulary(),
            home.individuals()::containsKey,
            FreeVariables.of(goal),
            (problem, cure) -> {
              throw new InvalidGoalException("The goal " + problem + "; " + cure + ".");
            })
        .check(goal);
  }

  private void checkNames(List<Term> terms) {
    Collection<String> known = home.individuals().keySet();
    for (Term term : terms) {
      if (term instanceof Term.Name name && !known.contains(name.text())) {
        throw new InvalidGoalException(
            "Nobody knows a thing named %s; %s."
                .formatted(
                    name.text(),
                    Nearest.cure(
                        name.text(), known, "name one of the home, such as " + example(known))));
      }
    }
  }

  private static String example(Collection<String> known) {
    return known.stream().limit(3).reduce((a, b) -> a + ", " + b).orElse("none (it is empty)");
  }
}
