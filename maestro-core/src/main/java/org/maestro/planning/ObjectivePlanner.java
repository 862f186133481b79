package org.maestro.planning;

import java.util.List;
import java.util.Optional;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;

/** The allocation strategy: whatever is to be planned is planned for one objective. */
public final class ObjectivePlanner implements Planner {
  private final Planner within;
  private final Objective objective;

  public ObjectivePlanner(Planner within, Objective objective) {
    this.within = within;
    this.objective = objective;
  }

  @Override
  public PlanningResult plan(PlanningTask task) {
    return within.plan(task.withObjective(objective));
  }

  @Override
  public PlanningResult solve(PlanningTask task) {
    return within.solve(task.withObjective(objective));
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    return within.revalidate(task.withObjective(objective), steps);
  }
}
