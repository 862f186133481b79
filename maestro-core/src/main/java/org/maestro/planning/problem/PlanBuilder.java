package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;

/** Executes a sequence of operators and writes it down as a plan. */
public final class PlanBuilder {
  private PlanBuilder() {}

  /** The plan whose operators are applicable one after the other. */
  public static Plan plan(GroundProblem problem, List<Operator> operators) {
    List<Set<Integer>> predecessors = StepOrder.predecessors(operators);
    List<Step> steps = new ArrayList<>();
    State state = problem.initial();
    double total = 0;
    for (int i = 0; i < operators.size(); i++) {
      Operator operator = operators.get(i);
      StepPrice price = operator.price();
      double cost = price.cost(state.numbers());
      Set<Integer> after = new TreeSet<>();
      predecessors.get(i).forEach(earlier -> after.add(earlier + 1));
      steps.add(
          new Step(
              i + 1,
              operator.feature().member(),
              operator.feature().type(),
              operator.bindings(),
              cost,
              price.seconds(state.numbers()),
              price.exact(),
              Collections.unmodifiableSet(after)));
      total += cost;
      state = Successors.after(operator, state);
    }
    return new Plan(steps, total, problem.goal().bindingIn(state));
  }
}
