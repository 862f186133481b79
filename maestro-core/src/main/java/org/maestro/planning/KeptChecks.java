package org.maestro.planning;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.grounding.GroundingCache;
import org.maestro.sl.Formula;

/**
 * Checks plans again and again while things change around them. What was asked of the facts for the
 * last check of the same steps is asked again only where it may be otherwise; when nothing is, the
 * answer stands. Thread-safe; a call computes on the caller's thread.
 */
final class KeptChecks {
  /** About as many as goals that are pursued beside each other. */
  private static final int MOST_KEPT = 128;

  /** About 15 MB. */
  private static final int MOST_INSTANCES = 10_000;

  /**
   * @param barred those of the steps that may not be taken
   */
  private record Subject(
      Formula goal, Objective objective, List<StepKey> steps, List<StepKey> barred) {
    static Subject of(PlanningTask task, List<Step> steps) {
      List<StepKey> keys = steps.stream().map(Step::key).toList();
      return new Subject(
          task.goal(),
          task.objective(),
          keys,
          keys.stream().filter(task.barred()::contains).toList());
    }
  }

  private record Kept(PlanningTask task, GroundingCache work, Optional<Plan> answer) {}

  private final Map<Subject, Kept> kept = new LinkedHashMap<>();

  /** Whether the steps still lead to the task's goal, and at what cost. */
  Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    Subject subject = Subject.of(task, steps);
    Optional<Kept> before =
        taken(subject)
            .filter(known -> known.task().vocabulary().equals(task.vocabulary()))
            .filter(known -> areTheSame(known.task().features(), task.features()));
    Kept now =
        before.flatMap(known -> again(known, task, steps)).orElseGet(() -> anew(task, steps));
    keep(subject, now);
    return now.answer();
  }

  private static Optional<Kept> again(Kept known, PlanningTask task, List<Step> steps) {
    GroundingCache work = known.work();
    return work.takeFacts(task.facts())
        .map(
            otherwise ->
                new Kept(
                    task,
                    work,
                    otherwise
                        ? OptimalPlanner.revalidate(new Grounder(work, task), steps)
                        : known.answer()));
  }

  private static Kept anew(PlanningTask task, List<Step> steps) {
    GroundingCache work = GroundingCache.forSteps(task, steps);
    return new Kept(task, work, OptimalPlanner.revalidate(new Grounder(work, task), steps));
  }

  /** Lists that are made anew of the same features are compared by these. */
  @SuppressWarnings("ReferenceEquality") // To compare whole descriptions would take too long.
  private static boolean areTheSame(List<PricedFeature> some, List<PricedFeature> others) {
    if (some == others) {
      return true;
    }
    if (some.size() != others.size()) {
      return false;
    }
    for (int i = 0; i < some.size(); i++) {
      if (some.get(i) != others.get(i)) {
        return false;
      }
    }
    return true;
  }

  /** Nobody else has it meanwhile. */
  private synchronized Optional<Kept> taken(Subject subject) {
    return Optional.ofNullable(kept.remove(subject));
  }

  private synchronized void keep(Subject subject, Kept now) {
    kept.put(subject, now);
    int instances = kept.values().stream().mapToInt(each -> each.work().size()).sum();
    Iterator<Kept> oldest = kept.values().iterator();
    while (kept.size() > MOST_KEPT || kept.size() > 1 && instances > MOST_INSTANCES) {
      instances -= oldest.next().work().size();
      oldest.remove();
    }
  }
}
