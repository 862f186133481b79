package org.maestro.planning;

import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SortedSet;
import java.util.TreeSet;
import java.util.function.Function;

/**
 * Plans with the cheap features first. A plan that costs no more than the cheapest feature left out
 * cannot be beaten by one that uses it, and once a plan is found, no feature dearer than it need be
 * looked at: so most goals never ground the dear features, of which there are the most instances.
 * The plan is as cheap as that of the planner within; where it searches, it begins with a look that
 * no dearer feature could better. Thread-safe if that is.
 */
public final class TieredPlanner implements Planner {
  private final Planner within;

  public TieredPlanner(Planner within) {
    this.within = within;
  }

  @Override
  public PlanningResult plan(PlanningTask task) {
    return planned(task, within::plan);
  }

  @Override
  public PlanningResult solve(PlanningTask task) {
    return planned(task, within::solve);
  }

  /** Only costs are in tiers. */
  private PlanningResult planned(PlanningTask task, Function<PlanningTask, PlanningResult> lastly) {
    if (task.objective() != Objective.CHEAPEST) {
      return lastly.apply(task);
    }
    LeastPrice leastPrice = new LeastPrice(task);
    Map<PricedFeature, Double> least = new IdentityHashMap<>();
    SortedSet<Double> tiers = new TreeSet<>();
    for (PricedFeature feature : task.features()) {
      double price = leastPrice.of(feature);
      least.put(feature, price);
      tiers.add(price);
    }
    double bound = Double.POSITIVE_INFINITY;
    for (double tier : tiers) {
      if (tier == tiers.last() || tier >= bound) {
        break;
      }
      List<PricedFeature> cheap =
          task.features().stream().filter(feature -> least.get(feature) <= tier).toList();
      PlanningResult result = within.solve(task.withFeatures(cheap));
      if (result instanceof PlanningResult.Found found) {
        bound = worthLookingAt(found.plan());
        double next = tiers.tailSet(Math.nextUp(tier)).first();
        if (bound <= next) {
          return result;
        }
        break;
      }
    }
    double most = bound;
    return lastly.apply(
        task.withFeatures(
            task.features().stream().filter(feature -> least.get(feature) <= most).toList()));
  }

  /**
   * Where the plan searches, it may be better to look elsewhere first with a feature that is dearer
   * than the whole of an optimistic plan.
   */
  private static double worthLookingAt(Plan plan) {
    return plan.searches().stream()
        .mapToDouble(PlannedSearch::dearestUsefulLook)
        .reduce(plan.cost(), Math::max);
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    return within.revalidate(task, steps);
  }
}
