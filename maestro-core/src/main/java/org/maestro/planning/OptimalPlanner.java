package org.maestro.planning;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.planning.PlanningResult.Explanation;

/**
 * Finds cheapest plans, or those that are over first, and proves it: backward grounding, A* with
 * landmark cuts, knapsack bounds for sums of settings. Stateless and thread-safe.
 */
public final class OptimalPlanner implements Planner {
  /** About 100 MB for homes of some ten devices. */
  public static final int DEFAULT_MOST_STATES = 200_000;

  /** For plans that begin a search elsewhere: they are worth less time. */
  private static final int MOST_STATES_BESIDE = 1_000;

  /** For the plan that is over first. */
  private static final int MOST_SCHEDULES = 20_000;

  private final int mostStates;

  public OptimalPlanner() {
    this(DEFAULT_MOST_STATES);
  }

  /**
   * A planner with a bound.
   *
   * @param mostStates states kept at once, from 1; beyond it {@link PlanningResult.GaveUp} is the
   *     answer
   * @throws IllegalArgumentException when the bound is below 1
   */
  public OptimalPlanner(int mostStates) {
    if (mostStates < 1) {
      throw new IllegalArgumentException(
          "The planner needs room for 1 state at least, not for " + mostStates + ".");
    }
    this.mostStates = mostStates;
  }

  @Override
  public PlanningResult plan(PlanningTask task) {
    PlanningResult result = solve(task);
    return result instanceof PlanningResult.Impossible
        ? new PlanningResult.Impossible(
            FailureExplanation.of(task, mostStates / 10 + 1, this::isSolvable))
        : result;
  }

  @Override
  public PlanningResult solve(PlanningTask task) {
    return solved(task, true);
  }

  /** The plan that is cheapest when all is found where it is looked for first. */
  PlanningResult optimistic(PlanningTask task) {
    return solved(task, false);
  }

  private boolean isSolvable(PlanningTask task) {
    return optimistic(task) instanceof PlanningResult.Found;
  }

  private PlanningResult solved(PlanningTask task, boolean weighingSearches) {
    Grounder grounder = new Grounder(task);
    GroundProblem ground = grounder.ground();
    if (!new RelaxedProblem(ground).isSolvable()) {
      return impossible(task);
    }
    GroundProblem problem = Pruning.pruned(ground, task.objective());
    OptimalSearch.Outcome outcome = search(problem, mostStates);
    if (outcome instanceof OptimalSearch.Outcome.Found found
        && task.objective() == Objective.EARLIEST_FINISH) {
      return earliest(problem, PlanBuilder.plan(problem, found.operators()));
    } else if (outcome instanceof OptimalSearch.Outcome.Found found) {
      return new PlanningResult.Found(
          weighingSearches
              ? new ExpectedCostSearch(
                      problem, grounder.chances(), this::cheapest, found.operators())
                  .plan()
              : PlanBuilder.plan(problem, found.operators()));
    } else if (outcome instanceof OptimalSearch.Outcome.Exhausted) {
      return impossible(task);
    }
    return new PlanningResult.GaveUp(
        "No plan and no proof that there is none within "
            + mostStates
            + " states; allow more states or state a smaller goal.");
  }

  /** Exact in small problems; else the cheapest plan or a better one, and what no plan is below. */
  private PlanningResult earliest(GroundProblem problem, Plan cheapest) {
    EarliestFinishSearch.Outcome outcome =
        new EarliestFinishSearch(problem, cheapest.seconds(), Math.min(mostStates, MOST_SCHEDULES))
            .run();
    if (outcome instanceof EarliestFinishSearch.Outcome.Found found) {
      return new PlanningResult.Found(PlanBuilder.plan(problem, found.operators()));
    }
    return outcome instanceof EarliestFinishSearch.Outcome.BoundReached bound
        ? new PlanningResult.Found(cheapest, OptionalDouble.of(bound.atLeastSeconds()))
        : new PlanningResult.Found(cheapest);
  }

  private static OptimalSearch.Outcome search(GroundProblem problem, int mostStates) {
    LandmarkCut heuristic = new LandmarkCut(new RelaxedProblem(problem));
    return new OptimalSearch(problem, heuristic, mostStates).run();
  }

  /** Empty when there is no plan, or none within a smaller bound. */
  private Optional<List<Operator>> cheapest(GroundProblem problem) {
    return new RelaxedProblem(problem).isSolvable()
            && search(Pruning.pruned(problem), Math.min(mostStates, MOST_STATES_BESIDE))
                instanceof OptimalSearch.Outcome.Found found
        ? Optional.of(found.operators())
        : Optional.empty();
  }

  private static PlanningResult impossible(PlanningTask task) {
    return new PlanningResult.Impossible(
        new Explanation(List.of(ObstacleText.ofGoal(task.goal())), false));
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    Grounder grounder = new Grounder(task);
    List<List<Operator>> choices = new ArrayList<>();
    for (Step step : steps) {
      choices.add(grounder.instances(step.key()));
    }
    List<Operator> all =
        new ArrayList<>(new LinkedHashSet<>(choices.stream().flatMap(List::stream).toList()));
    return Execution.plan(all, grounder.goal(), choices);
  }
}
