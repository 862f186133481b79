package org.maestro.coordination.maintenance;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.facts.ProgressedState;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Truth;

/**
 * Plans whose steps come one after another, in an order in which a condition goes on holding, if
 * there is one: a source is turned up before another is turned down. Thread-safe as its planner is.
 */
final class HoldingOrder implements Planner {
  private final Planner planner;
  private final Formula held;

  /**
   * @param held without free variables
   */
  HoldingOrder(Planner planner, Formula held) {
    this.planner = planner;
    this.held = held;
  }

  @Override
  public PlanningResult plan(PlanningTask task) {
    PlanningResult result = planner.plan(task);
    return result instanceof PlanningResult.Found found
        ? found.with(ordered(task, found.plan()))
        : result;
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    return planner.revalidate(task, steps);
  }

  private Plan ordered(PlanningTask task, Plan plan) {
    List<Step> left = new ArrayList<>(plan.steps());
    List<Step> chain = new ArrayList<>();
    Set<Integer> done = new HashSet<>();
    Facts facts = task.facts();
    while (!left.isEmpty()) {
      Facts present = facts;
      List<Step> possible = left.stream().filter(s -> done.containsAll(s.after())).toList();
      Step next =
          possible.stream()
              .filter(step -> holds(ProgressedState.of(present, task.vocabulary(), step)))
              .findFirst()
              .orElse(possible.get(0));
      facts = ProgressedState.of(facts, task.vocabulary(), next);
      left.remove(next);
      done.add(next.number());
      chain.add(linked(next, chain.size()));
    }
    return new Plan(chain, plan.cost(), plan.goalBinding());
  }

  private boolean holds(Facts facts) {
    return new Evaluation(facts).truth(held, Map.of()) == Truth.TRUE;
  }

  private static Step linked(Step step, int before) {
    return new Step(
        before + 1,
        step.member(),
        step.feature(),
        step.bindings(),
        step.cost(),
        step.seconds(),
        step.exactPrice(),
        before == 0 ? Set.of() : Set.of(before));
  }
}
