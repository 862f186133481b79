package org.maestro.planning;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.grounding.GroundingCache;
import org.maestro.sl.Formula;

/**
 * Finds what {@link OptimalPlanner} finds, sooner when it has planned before: it keeps what was
 * made for the goals planned for last, and what no goal changes serves the others too. Who left
 * takes away what he could do, who joined adds his own; the rest of the old plan is the first upper
 * bound, and stays the plan while none is cheaper. What was asked of the facts then is asked again
 * where it may be otherwise; what rests on answers that do not fit is made anew. Thread-safe; a
 * call computes on the caller's thread.
 */
public final class ReplanningPlanner implements Planner {
  /**
   * Goals for which plans are kept; each may take some megabytes in homes of a thousand devices.
   */
  private static final int MOST_KEPT = 6;

  /** About 600 MB; the groundwork for a building of a thousand devices takes half of it. */
  private static final int MOST_INSTANCES = 300_000;

  private record Subject(Formula goal, Objective objective) {}

  /** The groundwork for one home and what can be changed in it, and for goals there. */
  private record Kept(GroundingCache work, Map<Subject, KeptPlanning> plannings) {
    KeptPlanning planning(Subject subject, PlanningTask task) {
      KeptPlanning planning = plannings.remove(subject);
      if (planning == null) {
        planning = new KeptPlanning(work, task);
      } else {
        planning.renew(task);
      }
      plannings.put(subject, planning);
      List<Subject> oldest = new ArrayList<>(plannings.keySet());
      plannings.keySet().removeAll(oldest.subList(0, Math.max(0, oldest.size() - MOST_KEPT)));
      return planning;
    }

    /** What goals left behind is too much. */
    void shed() {
      work.shed();
      plannings.clear();
    }

    /** Goes over to the task; false when this is of no more use. */
    boolean renew(PlanningTask task) {
      int before = work.generation();
      boolean renewed = work.renew(task);
      if (work.generation() != before) {
        plannings.clear();
      }
      return renewed;
    }
  }

  private final OptimalPlanner planner;
  private final KeptChecks checks = new KeptChecks();

  /** The one used last comes first. */
  private final Deque<Kept> kept = new ArrayDeque<>();

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
    return OptimalPlanner.withFewAlike(task, this::solved);
  }

  private PlanningResult solved(PlanningTask task) {
    Subject subject = new Subject(task.goal(), task.objective());
    Kept used =
        taken(subject, task)
            .filter(known -> known.renew(task))
            .orElseGet(() -> new Kept(new GroundingCache(task), new LinkedHashMap<>()));
    PlanningResult result = used.planning(subject, task).solve(planner.mostStates());
    keep(used);
    return result;
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    return checks.revalidate(task, steps);
  }

  /** Nobody else has it meanwhile. */
  private synchronized Optional<Kept> taken(Subject subject, PlanningTask task) {
    Optional<Kept> found =
        kept.stream()
            .filter(known -> known.plannings().containsKey(subject))
            .filter(known -> known.work().suits(task))
            .findFirst()
            .or(
                () ->
                    kept.stream()
                        .filter(known -> known.work().suits(task) && known.work().isNear(task))
                        .findFirst());
    found.ifPresent(kept::remove);
    return found;
  }

  private synchronized void keep(Kept used) {
    if (!used.work().isWorn()) {
      kept.addFirst(used);
    }
    while (kept.size() > MOST_KEPT || kept.size() > 1 && size() > MOST_INSTANCES) {
      kept.removeLast();
    }
    if (size() > MOST_INSTANCES) {
      used.shed();
    }
  }

  private int size() {
    return kept.stream().mapToInt(each -> each.work().size()).sum();
  }
}
