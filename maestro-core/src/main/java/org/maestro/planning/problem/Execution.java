package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.StepKey;

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
    return taken(problem.initial(), choices)
        .filter(taken -> goal.condition().holds(after(taken, problem.initial())))
        .map(taken -> PlanBuilder.plan(problem, taken));
  }

  /** Those operators that the steps are, one after the other; empty when one cannot be taken. */
  public static Optional<List<Operator>> operators(
      List<Operator> among, State initial, List<StepKey> steps) {
    Map<StepKey, List<Operator>> byKey =
        among.stream().collect(Collectors.groupingBy(Operator::key));
    return taken(initial, steps.stream().map(key -> byKey.getOrDefault(key, List.of())).toList());
  }

  /** The state after operators that can be taken one after the other. */
  public static State after(List<Operator> operators, State initial) {
    State state = initial;
    for (Operator operator : operators) {
      state = Successors.after(operator, state);
    }
    return state;
  }

  private static Optional<List<Operator>> taken(State initial, List<List<Operator>> choices) {
    State state = initial;
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
    return Optional.of(taken);
  }
}
