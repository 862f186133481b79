package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.planning.api.Plan;

/** Executes given steps over the planning state, without searching. */
public final class Execution {
  private Execution() {}

  /**
   * The plan, or empty when a step cannot be taken or the goal is missed.
   *
   * @param choices for each step the operators it may mean, of which at most one is applicable
   */
  public static Optional<Plan> plan(
      List<Operator> operators, GroundGoal goal, List<List<Operator>> choices) {
    Relevance everything = new Relevance(target -> List.of());
    everything.closeWithAll(operators, goal.condition());
    GroundProblem problem = GroundProblem.complete(everything, goal);
    State state = problem.initial();
    List<Operator> taken = new ArrayList<>();
    for (List<Operator> choice : choices) {
      State before = state;
      Optional<Operator> next =
          choice.stream().filter(operator -> Successors.isApplicable(operator, before)).findFirst();
      if (next.isEmpty()) {
        return Optional.empty();
      }
      taken.add(next.get());
      state = Successors.after(next.get(), state);
    }
    return goal.condition().holds(state)
        ? Optional.of(PlanBuilder.plan(problem, taken))
        : Optional.empty();
  }
}
