package org.maestro.planning;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.sl.Formula;

/**
 * Finds what {@link OptimalPlanner} finds, sooner when it has planned for the same goal before: it
 * keeps what was made for the goals planned for last. Who left takes away what he could do, who
 * joined adds his own; the rest of the old plan is the first upper bound, and stays the plan while
 * none is cheaper. Whatever was asked of the facts then is asked again, and where the answers do
 * not fit, all is made anew. Thread-safe; a call computes on the caller's thread.
 */
public final class ReplanningPlanner implements Planner {
  /** Each may take some megabytes in homes of a thousand devices. */
  private static final int MOST_KEPT = 6;

  private record Subject(Formula goal, Objective objective) {}

  private final OptimalPlanner planner;
  private final Map<Subject, KeptPlanning> kept = new LinkedHashMap<>();

  /**
   * @param planner bounds the states that are kept at once
   */
  public ReplanningPlanner(OptimalPlanner planner) {
    this.planner = planner;
  }

  @Override
  public PlanningResult plan(PlanningTask task) {
    return planner.explained(task, solve(task));
  }

  @Override
  public PlanningResult solve(PlanningTask task) {
    Subject subject = new Subject(task.goal(), task.objective());
    KeptPlanning planning =
        taken(subject).filter(known -> known.renew(task)).orElseGet(() -> new KeptPlanning(task));
    PlanningResult result = planning.solve(planner.mostStates());
    keep(subject, planning);
    return result;
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    return planner.revalidate(task, steps);
  }

  /** Nobody else has it meanwhile. */
  private synchronized Optional<KeptPlanning> taken(Subject subject) {
    return Optional.ofNullable(kept.remove(subject));
  }

  private synchronized void keep(Subject subject, KeptPlanning planning) {
    kept.put(subject, planning);
    List<Subject> oldest = new ArrayList<>(kept.keySet());
    kept.keySet().removeAll(oldest.subList(0, Math.max(0, oldest.size() - MOST_KEPT)));
  }
}
