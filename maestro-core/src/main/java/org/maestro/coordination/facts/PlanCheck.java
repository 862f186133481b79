package org.maestro.coordination.facts;

import java.util.List;
import java.util.Optional;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.sl.Formula;

/** Compares what is known with what a plan counts on. */
public final class PlanCheck {
  private static final double SAME_COST = 1e-6;

  private final Planner planner;

  public PlanCheck(Planner planner) {
    this.planner = planner;
  }

  /** The binding under which the task's goal holds already, in a plan without steps. */
  public Optional<Plan> holds(PlanningTask task) {
    return planner.revalidate(task, List.of());
  }

  /** Whether the steps still reach the goal, and at no higher cost than planned. */
  public boolean isGood(PlanningTask task, List<Step> steps) {
    double planned = steps.stream().mapToDouble(Step::cost).sum();
    return planner
        .revalidate(task, steps)
        .filter(now -> now.cost() <= planned + SAME_COST)
        .isPresent();
  }

  /** The first step that cannot be done any more. */
  public Optional<Step> blocked(PlanningTask task, List<Step> steps) {
    PlanningTask anything =
        new PlanningTask(
            task.vocabulary(),
            task.facts(),
            task.features(),
            new Formula.And(List.of()),
            task.barred());
    for (int n = 1; n <= steps.size(); n++) {
      if (planner.revalidate(anything, steps.subList(0, n)).isEmpty()) {
        return Optional.of(steps.get(n - 1));
      }
    }
    return Optional.empty();
  }
}
