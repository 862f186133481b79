package org.maestro.coordination.api;

import java.util.Set;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.StatementCheck;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.NumberVariables;

/**
 * Refuses goals that speak of what neither home nor vocabulary know, before anybody is asked for
 * anything.
 */
public final class GoalCheck {
  private final StatementCheck statements;
  private final StatementCheck benefits;

  /** For goals in this home. */
  public GoalCheck(Home home) {
    this.statements = new StatementCheck(home, "The goal");
    this.benefits = new StatementCheck(home, "The benefit");
  }

  /**
   * Looks at every word of a goal, and of what it is said to bring.
   *
   * @throws InvalidGoalException for the first that is wrong
   */
  public void check(GoalRequest request) {
    check(request.goal());
    request.stakes().map(Stakes::benefit).ifPresent(this::checkBenefit);
  }

  private void checkBenefit(Expression benefit) {
    benefits
        .fault(benefit)
        .or(
            () ->
                FreeVariables.of(benefit).stream()
                    .findFirst()
                    .map(
                        open ->
                            "The benefit leaves ?%s open; write a name in its place."
                                .formatted(open)))
        .ifPresent(
            sentence -> {
              throw new InvalidGoalException(sentence);
            });
  }

  /**
   * Looks at every word of a goal.
   *
   * @throws InvalidGoalException for the first that is wrong
   */
  public void check(Formula goal) {
    statements
        .fault(goal)
        .ifPresent(
            sentence -> {
              throw new InvalidGoalException(sentence);
            });
    Set<String> open = NumberVariables.of(goal);
    if (!open.isEmpty()) {
      throw new InvalidGoalException(
          "The goal leaves the number ?%s open; write one in its place."
              .formatted(open.iterator().next()));
    }
  }
}
