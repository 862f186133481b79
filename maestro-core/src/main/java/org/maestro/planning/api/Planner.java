package org.maestro.planning.api;

import java.util.List;

/** Finds cheapest plans. Thread-safe; a call computes on the caller's thread. */
public interface Planner {

  /** The best plan for the task's objective, or why there is none. */
  PlanningResult plan(PlanningTask task);

  /** As {@link #plan}, but without the pains of saying why there is none. */
  default PlanningResult solve(PlanningTask task) {
    return plan(task);
  }

  /**
   * Whether these steps, in their order, still lead from the task's facts to its goal, and at what
   * cost.
   *
   * @return a plan with the steps' present prices, or empty when a precondition fails or the goal
   *     is missed
   */
  java.util.Optional<Plan> revalidate(PlanningTask task, List<Step> steps);
}
