package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.problem.Execution;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.PlanBuilder;

/**
 * The problem that was grounded for a goal, and lower bounds on the cost of plans that use its
 * operators. Whoever leaves only takes operators away, and these bounds stay true; whoever comes
 * back brings the same ones. For one thread at a time.
 */
public final class KeptGround {
  private static final double ROUNDING = 1e-6;

  /** Of the cost of the cheapest plan with everybody: by so much the limit grows at first. */
  private static final double FIRST_STEP = 0.1;

  /** Of the limit's distance from that cost, from one search to the next. */
  private static final double GROWTH = 2;

  private final GroundProblem problem;
  private final CostBounds bounds;
  private final double beyond;
  private final double cheapest;
  private final Set<Integer> features;
  private final PlanningTask task;
  private Optional<double[]> costs = Optional.empty();

  /**
   * @param bounds of that problem
   * @param beyond a plan that costs less uses no operators but the problem's
   * @param cheapest what the cheapest plan of the problem costs
   * @param features the numbers of those that were there
   * @param task for which the problem was grounded
   */
  public KeptGround(
      GroundProblem problem,
      CostBounds bounds,
      double beyond,
      double cheapest,
      Set<Integer> features,
      PlanningTask task) {
    this.problem = problem;
    this.bounds = bounds;
    this.beyond = beyond;
    this.cheapest = cheapest;
    this.features = features;
    this.task = task;
  }

  /** With fewer members too, a plan that costs less uses no operators but the problem's. */
  public double beyond() {
    return beyond;
  }

  /** The problem, with its variables at their places. */
  public GroundProblem problem() {
    return problem.placed();
  }

  /**
   * The cheapest plan of a task in which all that is known is as it was.
   *
   * @return empty when more than this is needed to know
   */
  public Optional<PlanningResult.Found> cheapest(
      PlanningTask now, Grounder grounder, Effort effort) {
    if (now.objective() != Objective.CHEAPEST
        || !features.containsAll(grounder.featuresThere())
        || !now.barred().containsAll(task.barred())) {
      return Optional.empty();
    }
    problem.placed();
    double[] least = costs.orElseGet(bounds::costsWith);
    costs = Optional.of(least);
    List<Operator> there = new ArrayList<>();
    List<Double> leastOf = new ArrayList<>();
    Set<PricedFeature> present = grounder.present();
    for (int i = 0; i < least.length; i++) {
      Operator operator = problem.operators().get(i);
      if (present.contains(operator.feature()) && !now.barred().contains(operator.key())) {
        there.add(operator);
        leastOf.add(least[i]);
      }
    }
    double limit = cheapest;
    while (limit < beyond - ROUNDING) {
      List<Operator> useful = new ArrayList<>();
      double next = beyond;
      for (int i = 0; i < there.size(); i++) {
        if (leastOf.get(i) <= limit + ROUNDING) {
          useful.add(there.get(i));
        } else {
          next = Math.min(next, leastOf.get(i));
        }
      }
      OptimalSearch.Outcome outcome = among(useful, limit + ROUNDING, effort);
      if (outcome instanceof OptimalSearch.Outcome.Found found) {
        return Optional.of(found(found.operators(), there));
      } else if (outcome instanceof OptimalSearch.Outcome.BoundReached) {
        return Optional.empty();
      } else if (outcome instanceof OptimalSearch.Outcome.TooDear dear) {
        next = Math.min(next, dear.atLeast());
      }
      double step = Math.max(GROWTH * (limit - cheapest), FIRST_STEP * cheapest);
      limit = Math.max(next, cheapest + step);
    }
    return Optional.empty();
  }

  private OptimalSearch.Outcome among(List<Operator> useful, double limit, Effort effort) {
    Pruning.Pruned pruned = Pruning.pruned(problem.with(useful));
    if (!pruned.isSolvable()) {
      return new OptimalSearch.Outcome.Exhausted(1);
    }
    OptimalSearch.Outcome outcome =
        new OptimalSearch(
                pruned.problem().placed(), new LandmarkCut(pruned.relaxed()), effort, limit)
            .run();
    problem.placed();
    return outcome instanceof OptimalSearch.Outcome.Found found
        ? new OptimalSearch.Outcome.Found(originals(found.operators(), useful))
        : outcome;
  }

  /** The problem's own operators: those that were searched may have fewer changes. */
  private List<Operator> originals(List<Operator> found, List<Operator> useful) {
    List<StepKey> steps = found.stream().map(Operator::key).toList();
    return Execution.operators(useful, problem.initial(), steps).orElseThrow();
  }

  private PlanningResult.Found found(List<Operator> operators, List<Operator> there) {
    Plan plan = PlanBuilder.plan(problem, operators);
    Set<String> contenders = new LinkedHashSet<>(plan.members());
    there.forEach(operator -> contenders.add(operator.feature().member()));
    return new PlanningResult.Found(plan, OptionalDouble.empty(), contenders);
  }
}
