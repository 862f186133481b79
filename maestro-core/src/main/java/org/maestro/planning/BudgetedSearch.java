package org.maestro.planning;

import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningResult.Explanation;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.explanation.ObstacleText;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.optimal.CostBounds;
import org.maestro.planning.optimal.KeptGround;
import org.maestro.planning.optimal.LandmarkCut;
import org.maestro.planning.optimal.LimitedSearch;
import org.maestro.planning.optimal.MakespanSearch;
import org.maestro.planning.optimal.OptimalSearch;
import org.maestro.planning.optimal.PlansOfOne;
import org.maestro.planning.optimal.Pruning;
import org.maestro.planning.optimal.RelaxedProblem;
import org.maestro.planning.optimal.RivalSteps;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.PlanBuilder;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.sensing.ExpectedCostSearch;
import org.maestro.planning.sensing.MostLikelyState;

/**
 * Finds the plan of one task. Most goals are reached with few of all steps: a budget grows until
 * there is a plan within it, which then is the cheapest of all. Only proof that there is none needs
 * all steps that matter.
 */
final class BudgetedSearch {
  /** Of the budget from one round to the next. */
  private static final double GROWTH = 1.5;

  /**
   * As long as nothing is searched: what is made ground in vain takes longer than to look again.
   */
  private static final double GROWTH_UNTIL_IN_REACH = 1.05;

  /** So that rounding does not keep it where it is. */
  private static final double LEAST_GROWTH = 1.02;

  /** Where each round takes a second. */
  private static final double LEAST_GROWTH_OF_MUCH = 1.1;

  /** A proof which plan is the cheapest takes longer among them than anybody waits. */
  private static final int MANY_OPERATORS = 4_000;

  /** To make more of them ground takes many seconds. */
  private static final int MOST_OPERATORS = 40_000;

  /** For plans that begin a search elsewhere: they are worth less time. */
  private static final int MOST_STATES_BESIDE = 1_000;

  /** How many times as much as the cheapest a plan may cost that is taken for want of a better. */
  private static final double HASTE = 5;

  /** For the plan that is over first. */
  private static final int MOST_SCHEDULES = 20_000;

  /**
   * The grounded problem, and the bounds that it gives.
   *
   * @param beyond the budget from which on there is more to be grounded
   * @param bounds empty where there is no plan, as the relaxation shows
   */
  private record Ground(GroundProblem problem, double beyond, Optional<CostBounds> bounds) {}

  /**
   * The problem that was searched in one round, and the outcome.
   *
   * @param beyond the budget from which on other steps may be of use
   */
  private record Round(GroundProblem problem, double beyond, OptimalSearch.Outcome outcome) {}

  private final PlanningTask task;
  private final Grounder grounder;
  private final int mostStates;
  private final Effort effort;
  private final boolean weighingSearches;
  private final SupposedPlans supposedPlans = new SupposedPlans();
  private Optional<Ground> solved = Optional.empty();
  private double lastBudget;

  /**
   * @param grounder of that task
   * @param mostStates kept at once
   * @param weighingSearches whether to begin searches where the goal is expected to cost least;
   *     otherwise what is sought counts as found where it is looked for first
   */
  BudgetedSearch(PlanningTask task, Grounder grounder, int mostStates, boolean weighingSearches) {
    this.task = task;
    this.grounder = grounder;
    this.mostStates = mostStates;
    this.effort = Effort.forBestPlan(mostStates);
    this.weighingSearches = weighingSearches;
  }

  /** The problem of which the plan found is; empty when none was found, or it is not proven. */
  Optional<GroundProblem> solved() {
    return solved.map(Ground::problem);
  }

  /** The budget within which the plan was found. */
  double lastBudget() {
    return lastBudget;
  }

  /**
   * What was grounded for the plan found, to be asked again when members left.
   *
   * @param cost of that plan, the cheapest
   */
  Optional<KeptGround> kept(double cost) {
    return solved.flatMap(
        ground ->
            ground
                .bounds()
                .map(
                    bounds ->
                        new KeptGround(
                            ground.problem(),
                            bounds,
                            ground.beyond(),
                            cost,
                            grounder.featuresThere(),
                            task)));
  }

  /**
   * The plan.
   *
   * @param firstBudget to begin with: any is right, the cost of the plan is fast. Where something
   *     is sought it is none: which places are weighed against each other depends on the budget,
   *     and is not to depend on what was planned before
   */
  PlanningResult run(double firstBudget) {
    double budget = task.objective() == Objective.CHEAPEST ? firstBudget : Double.POSITIVE_INFINITY;
    lastBudget = budget;
    Ground ground = ground(budget);
    boolean fromNothing = !isWeighing() || budget == 0;
    while (true) {
      if (!fromNothing && !Sought.of(ground.problem()).isEmpty()) {
        // It may be beyond the first budget that something has to be sought.
        fromNothing = true;
        budget = 0;
        ground = ground(budget);
      }
      Round round = round(ground, budget);
      double next = Math.max(round.beyond(), budget * growth(ground));
      if (round.outcome() instanceof OptimalSearch.Outcome.Found found) {
        PlanningResult.Found result = result(round, found.operators());
        double worthLookingAt = worthLookingAt(result.plan());
        boolean mayBeBeyond = Double.isFinite(budget) && worthLookingAt >= round.beyond();
        if (!isWeighing() || !mayBeBeyond) {
          solved = Optional.of(ground);
          return result.withRivals(RivalSteps.of(round.problem(), result.plan()));
        }
        next = Math.min(next, Math.max(worthLookingAt, budget * LEAST_GROWTH));
      } else if (round.outcome() instanceof OptimalSearch.Outcome.Unproven unproven) {
        return some(round.problem(), unproven.operators(), least(ground));
      } else if (round.outcome() instanceof OptimalSearch.Outcome.BoundReached) {
        Optional<PlanningResult> plan = ofOne(round.problem(), least(ground));
        if (plan.isPresent()) {
          return plan.get();
        }
        if (!isMuch(round.problem()) || !mayGrow(ground)) {
          return somePlan(round.problem(), least(ground));
        }
      } else if (round.outcome() instanceof OptimalSearch.Outcome.TooDear tooDear) {
        double soon = Math.max(tooDear.atLeast(), Math.min(next, Math.nextDown(ground.beyond())));
        if (isMuch(ground.problem()) && least(ground) > budget) {
          Optional<PlanningResult> plan =
              ofOne(ground.problem(), Math.min(least(ground), ground.beyond()));
          if (plan.isPresent()) {
            return plan.get();
          }
          soon = Math.min(soon, Math.max(ground.beyond(), budget * GROWTH));
        }
        if (isMuch(ground.problem())) {
          soon = Math.max(soon, budget * LEAST_GROWTH_OF_MUCH);
        }
        next = soon > budget ? soon : next;
      } else if (round.beyond() == Double.POSITIVE_INFINITY) {
        return impossible();
      }
      budget = next;
      lastBudget = budget;
      ground = budget >= ground.beyond() ? ground(budget) : ground;
    }
  }

  private static double growth(Ground ground) {
    return ground.bounds().isEmpty() ? GROWTH_UNTIL_IN_REACH : GROWTH;
  }

  /** Whether there are so many steps that nobody waits for the proof which plan is the cheapest. */
  private boolean isMuch(GroundProblem problem) {
    return isWeighing()
        && problem.operators().size() >= MANY_OPERATORS
        && Sought.of(problem).isEmpty();
  }

  private static boolean mayGrow(Ground ground) {
    return ground.problem().operators().size() < MOST_OPERATORS && Double.isFinite(ground.beyond());
  }

  /** Empty where the problem is small, or no one can do it alone. */
  private Optional<PlanningResult> ofOne(GroundProblem problem, double atLeast) {
    if (!isMuch(problem)) {
      return Optional.empty();
    }
    return new PlansOfOne(problem.placed(), task.features(), mostStates)
        .cheapest(atLeast)
        .map(PlanningResult.class::cast);
  }

  private static double least(Ground ground) {
    return ground.bounds().map(CostBounds::least).orElse(0.0);
  }

  private PlanningResult givenUp() {
    return new PlanningResult.GaveUp(
        "No plan and no proof that there is none within "
            + mostStates
            + " states; state a smaller goal.");
  }

  private PlanningResult impossible() {
    return new PlanningResult.Impossible(
        new Explanation(List.of(ObstacleText.ofGoal(task)), false));
  }

  /**
   * Where the cheapest plan is too hard to find, any is better than none: first among the steps
   * that were tried, which are far fewer than all that matter.
   */
  private PlanningResult somePlan(GroundProblem tried, double atLeast) {
    if (!isWeighing()) {
      return givenUp();
    }
    if (isMuch(tried)) {
      OptimalSearch.Outcome overCases =
          new SearchOverCases(tried.placed(), mostStates).run(Double.POSITIVE_INFINITY);
      if (overCases instanceof OptimalSearch.Outcome.Unproven unproven) {
        return some(tried, unproven.operators(), atLeast);
      }
      if (overCases instanceof OptimalSearch.Outcome.Found found) {
        return some(tried, found.operators(), atLeast);
      }
    }
    if (hasty(tried, Effort.forBestPlan(mostStates)) instanceof OptimalSearch.Outcome.Found found) {
      return some(tried, found.operators(), atLeast);
    }
    Pruning.Pruned pruned =
        Pruning.pruned(grounder.ground(Double.POSITIVE_INFINITY).problem().placed());
    if (!pruned.isSolvable()) {
      return impossible();
    }
    OptimalSearch.Outcome outcome = hasty(pruned.problem(), Effort.forAnyPlan(mostStates));
    if (outcome instanceof OptimalSearch.Outcome.Exhausted) {
      return impossible();
    }
    return outcome instanceof OptimalSearch.Outcome.Found found
        ? some(pruned.problem(), found.operators(), atLeast)
        : givenUp();
  }

  private static OptimalSearch.Outcome hasty(GroundProblem problem, Effort effort) {
    LandmarkCut cuts = new LandmarkCut(new RelaxedProblem(problem.placed()));
    return OptimalSearch.hasty(problem, cuts, effort, HASTE).run();
  }

  private static PlanningResult some(
      GroundProblem problem, List<Operator> operators, double atLeast) {
    Plan plan = PlanBuilder.plan(problem.placed(), operators);
    return new PlanningResult.Found(plan, OptionalDouble.of(atLeast), plan.members());
  }

  private Ground ground(double budget) {
    Grounder.Grounded grounded = grounder.ground(budget);
    RelaxedProblem relaxed = new RelaxedProblem(grounded.problem());
    return new Ground(
        grounded.problem(),
        grounded.beyond(),
        relaxed.isSolvable()
            ? Optional.of(new CostBounds(grounded.problem(), relaxed))
            : Optional.empty());
  }

  private Round round(Ground ground, double budget) {
    GroundProblem problem = ground.problem().placed();
    double beyond = ground.beyond();
    if (ground.bounds().isEmpty()) {
      return new Round(problem, beyond, new OptimalSearch.Outcome.Exhausted(0));
    }
    CostBounds bounds = ground.bounds().get();
    if (bounds.least() > budget) {
      return new Round(problem, beyond, new OptimalSearch.Outcome.TooDear(bounds.least()));
    }
    if (Double.isFinite(budget) && Sought.hasManyPlaces(Sought.of(problem))) {
      CostBounds.Useful useful = bounds.useful(budget);
      problem = problem.with(useful.operators());
      beyond = Math.min(beyond, useful.beyond());
    }
    Pruning.Pruned pruned = Pruning.pruned(problem, task.objective());
    List<Sought> sought = Sought.of(pruned.problem());
    return new Round(
        pruned.problem(),
        beyond,
        weighingSearches && Sought.hasManyPlaces(sought)
            ? amongManyPlaces(pruned, sought, beyond, budget)
            : isMuch(pruned.problem())
                ? overStates(pruned, Effort.forSoonFoundPlan(mostStates), budget)
                : search(pruned, effort, budget));
  }

  /**
   * Where something may be in many places, a plan that counts on finding it in the cheapest one is
   * of little use, and hard to find among many like ones: where it is likeliest comes first.
   */
  private OptimalSearch.Outcome amongManyPlaces(
      Pruning.Pruned pruned, List<Sought> sought, double beyond, double budget) {
    boolean mayWait = Double.isFinite(beyond);
    if (mayWait && sought.stream().anyMatch(grounder.chances()::isLikelierOutOfView)) {
      return new OptimalSearch.Outcome.TooDear(budget);
    }
    MostLikelyState likeliest =
        MostLikelyState.likeliest(
            sought, grounder.chances(), pruned.problem().placed(), pruned.relaxed());
    OptimalSearch.Outcome outcome =
        search(Pruning.pruned(likeliest.appliedTo(pruned.problem())), effort, budget);
    pruned.problem().placed();
    boolean none =
        outcome instanceof OptimalSearch.Outcome.Exhausted
            || outcome instanceof OptimalSearch.Outcome.BoundReached;
    return none && !mayWait ? search(pruned, effort, budget) : outcome;
  }

  /**
   * Most plans are found at once; where states of many robots multiply, the search over cases finds
   * them, and without either of both it is gone on with until the effort is spent.
   */
  private OptimalSearch.Outcome search(Pruning.Pruned pruned, Effort whole, double mostCost) {
    if (!pruned.isSolvable()) {
      return new OptimalSearch.Outcome.Exhausted(0);
    }
    OptimalSearch.Outcome soon = soon(pruned, whole.mostStates(), mostCost);
    boolean isEnough =
        soon instanceof OptimalSearch.Outcome.Unproven
            ? isWeighing()
            : !(soon instanceof OptimalSearch.Outcome.BoundReached);
    return isEnough ? soon : overStates(pruned, whole, mostCost);
  }

  private OptimalSearch.Outcome soon(Pruning.Pruned pruned, int states, double mostCost) {
    OptimalSearch.Outcome atOnce = overStates(pruned, Effort.forSoonFoundPlan(states), mostCost);
    return atOnce instanceof OptimalSearch.Outcome.BoundReached
        ? new SearchOverCases(pruned.problem().placed(), states).run(mostCost)
        : atOnce;
  }

  private static OptimalSearch.Outcome overStates(
      Pruning.Pruned pruned, Effort effort, double mostCost) {
    return new LimitedSearch(pruned.problem(), pruned.relaxed(), effort, mostCost).run();
  }

  /**
   * Whether searches begin where the goal is expected to cost least; then a plan will do that is
   * not proven to be the best.
   */
  private boolean isWeighing() {
    return weighingSearches && task.objective() == Objective.CHEAPEST;
  }

  private PlanningResult.Found result(Round round, List<Operator> operators) {
    Plan cheapest = PlanBuilder.plan(round.problem().placed(), operators);
    if (task.objective() == Objective.EARLIEST_FINISH) {
      return earliest(round, cheapest);
    }
    return found(
        round,
        weighingSearches
            ? new ExpectedCostSearch(
                    round.problem(),
                    grounder.chances(),
                    (supposed, problem) -> cheapest(supposed, problem, round.beyond()),
                    operators)
                .plan()
            : cheapest);
  }

  /**
   * What an optimistic plan may cost whose look is a better first one, by chance over cost, than
   * that of this plan: beyond the budget there may be such a one. Infinite where this plan finds
   * nothing that is not known.
   */
  private static double worthLookingAt(Plan plan) {
    return plan.searches().stream()
        .mapToDouble(
            search -> plan.cost() - search.places().get(0).lookCost() + search.dearestUsefulLook())
        .reduce(plan.cost(), Math::max);
  }

  /** Exact in small problems; else the cheapest plan or a better one, and what no plan is below. */
  private PlanningResult.Found earliest(Round round, Plan cheapest) {
    GroundProblem problem = round.problem();
    MakespanSearch.Outcome outcome =
        new MakespanSearch(problem, cheapest.seconds(), Math.min(mostStates, MOST_SCHEDULES)).run();
    if (outcome instanceof MakespanSearch.Outcome.Found found) {
      return found(round, PlanBuilder.plan(problem, found.operators()));
    }
    return outcome instanceof MakespanSearch.Outcome.BoundReached bound
        ? new PlanningResult.Found(
            cheapest, OptionalDouble.of(bound.atLeastSeconds()), contenders(round, cheapest))
        : found(round, cheapest);
  }

  private static PlanningResult.Found found(Round round, Plan plan) {
    return new PlanningResult.Found(plan, OptionalDouble.empty(), contenders(round, plan));
  }

  private static Set<String> contenders(Round round, Plan plan) {
    Set<String> members = new LinkedHashSet<>(plan.members());
    round.problem().operators().forEach(operator -> members.add(operator.feature().member()));
    return members;
  }

  /** Empty when there is no plan, or none that is proven within a smaller bound. */
  private Optional<List<Operator>> cheapest(
      MostLikelyState supposed, GroundProblem problem, double beyond) {
    Pruning.Pruned pruned = Pruning.pruned(problem);
    if (!pruned.isSolvable()) {
      return Optional.empty();
    }
    Optional<List<Operator>> known = supposedPlans.of(supposed, pruned.problem().placed());
    if (known.isPresent() || supposedPlans.isInVain(supposed)) {
      return known;
    }
    OptimalSearch.Outcome outcome = soon(pruned, MOST_STATES_BESIDE, Double.POSITIVE_INFINITY);
    if (outcome instanceof OptimalSearch.Outcome.BoundReached) {
      Effort beside = Effort.forPlanBeside(MOST_STATES_BESIDE);
      outcome = overStates(pruned, beside, Double.POSITIVE_INFINITY);
    }
    if (outcome instanceof OptimalSearch.Outcome.Found found) {
      double cost = PlanBuilder.plan(pruned.problem().placed(), found.operators()).cost();
      supposedPlans.keep(supposed, found.operators(), cost, beyond);
      return Optional.of(found.operators());
    }
    if (!(outcome instanceof OptimalSearch.Outcome.Exhausted)) {
      supposedPlans.keepInVain(supposed);
    }
    return Optional.empty();
  }
}
