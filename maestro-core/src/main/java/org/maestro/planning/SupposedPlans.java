package org.maestro.planning;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.problem.Execution;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Sought;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Variable;
import org.maestro.planning.sensing.MostLikelyState;

/**
 * Cheapest plans, each for a supposition of where what is sought is, that were proven with one
 * budget. With a larger one there are more steps, all of which are of use only in plans that cost
 * more than the first budget left out: below that a plan is the cheapest still. For one task, whose
 * facts and prices do not change meanwhile.
 */
final class SupposedPlans {
  /**
   * @param places the value that each thing sought is supposed to have
   * @param amongMany whether looks elsewhere are left out
   */
  private record Supposition(Map<Variable, Integer> places, boolean amongMany) {
    static Supposition of(MostLikelyState state) {
      Map<Variable, Integer> places = new HashMap<>();
      state.places().forEach((sought, value) -> places.put(sought.variable(), value));
      return new Supposition(places, Sought.hasManyPlaces(state.places().keySet()));
    }
  }

  private final Map<Supposition, List<StepKey>> steps = new HashMap<>();
  private final Set<Supposition> inVain = new HashSet<>();

  /**
   * The plan for the supposition, if it is known, over the operators of this problem.
   *
   * @param problem whose variables are placed for it
   */
  Optional<List<Operator>> of(MostLikelyState supposed, GroundProblem problem) {
    State initial = problem.initial();
    return Optional.ofNullable(steps.get(Supposition.of(supposed)))
        .flatMap(known -> Execution.operators(problem.operators(), initial, known))
        .filter(plan -> problem.goal().condition().holds(Execution.after(plan, initial)));
  }

  /**
   * Keeps a plan that is proven the cheapest over the steps of use below a budget.
   *
   * @param cost of the plan
   * @param beyond what plans cost at least that use other steps
   */
  void keep(MostLikelyState supposed, List<Operator> plan, double cost, double beyond) {
    if (cost < beyond) {
      steps.put(Supposition.of(supposed), plan.stream().map(Operator::key).toList());
    }
  }

  /**
   * Keeps that no plan was proven within the effort that is made: among the more steps of a larger
   * budget none would be.
   */
  void keepInVain(MostLikelyState supposed) {
    inVain.add(Supposition.of(supposed));
  }

  /** Whether a search is not worth while, as one among fewer steps ended without a proof. */
  boolean isInVain(MostLikelyState supposed) {
    return inVain.contains(Supposition.of(supposed));
  }
}
