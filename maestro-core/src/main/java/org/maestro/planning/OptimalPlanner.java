package org.maestro.planning;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.planning.alike.FewAlike;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.explanation.FailureExplanation;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.problem.Execution;
import org.maestro.planning.problem.Operator;

/**
 * Finds cheapest plans, or those that are over first, and proves it: backward grounding, A* with
 * landmark cuts, knapsack bounds for sums of settings. Stateless and thread-safe.
 */
public final class OptimalPlanner implements Planner {
  /** About 100 MB for homes of some ten devices. */
  public static final int DEFAULT_MOST_STATES = 200_000;

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
    return explained(task, solve(task));
  }

  /** The result, with the reasons why there is no plan when there is none. */
  PlanningResult explained(PlanningTask task, PlanningResult result) {
    return result instanceof PlanningResult.Impossible
        ? new PlanningResult.Impossible(
            FailureExplanation.of(task, mostStates / 10 + 1, this::isSolvable))
        : result;
  }

  @Override
  public PlanningResult solve(PlanningTask task) {
    return withFewAlike(task, one -> solved(one, true));
  }

  /**
   * What is found with few of the members that are alike, where that is what is found with all of
   * them, or nothing is claimed to be the best. Else what is found with all of them.
   */
  static PlanningResult withFewAlike(
      PlanningTask task, Function<PlanningTask, PlanningResult> solver) {
    Optional<FewAlike> few = FewAlike.of(task);
    if (few.isPresent()
        && solver.apply(few.get().task()) instanceof PlanningResult.Found found
        && few.get().suffices(found)
        && leadsToTheGoal(task, found.plan())) {
      return few.get().withOthers(found);
    }
    return solver.apply(task);
  }

  /** With few of them a goal for all of them is a smaller one. */
  private static boolean leadsToTheGoal(PlanningTask task, Plan plan) {
    return revalidate(Grounder.forSteps(task, plan.steps()), plan.steps()).isPresent();
  }

  /** The plan that is cheapest when all is found where it is looked for first. */
  public PlanningResult optimistic(PlanningTask task) {
    return solved(task, false);
  }

  private boolean isSolvable(PlanningTask task) {
    return optimistic(task) instanceof PlanningResult.Found;
  }

  private PlanningResult solved(PlanningTask task, boolean weighingSearches) {
    return new BudgetedSearch(task, new Grounder(task), mostStates, weighingSearches).run(0);
  }

  int mostStates() {
    return mostStates;
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    return revalidate(Grounder.forSteps(task, steps), steps);
  }

  static Optional<Plan> revalidate(Grounder grounder, List<Step> steps) {
    List<List<Operator>> choices = new ArrayList<>();
    for (Step step : steps) {
      choices.add(grounder.instances(step.key()));
    }
    List<Operator> all =
        new ArrayList<>(new LinkedHashSet<>(choices.stream().flatMap(List::stream).toList()));
    return Execution.plan(all, grounder.goal(), choices);
  }
}
