package org.maestro.agents.goals;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Predicate;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;

/**
 * Plans, and remembers of each goal for which there is no plan which conditions nobody in its scope
 * can bring about: what to ask of others. Thread-safe.
 */
final class UnmetConditions implements Planner {
  private final Planner planner;
  private final Predicate<String> fluents;
  private final Map<Formula, Formula> lackingByGoal = new ConcurrentHashMap<>();

  /**
   * @param fluents which names are numbers
   */
  UnmetConditions(Planner planner, Predicate<String> fluents) {
    this.planner = planner;
    this.fluents = fluents;
  }

  /** What was lacking when the goal was last planned for; the goal itself when it is not known. */
  Formula of(Formula goal) {
    return lackingByGoal.getOrDefault(goal, goal);
  }

  @Override
  public PlanningResult plan(PlanningTask task) {
    PlanningResult result = planner.plan(task);
    if (result instanceof PlanningResult.Impossible impossible) {
      conditions(impossible.explanation())
          .ifPresentOrElse(
              lacking -> lackingByGoal.put(task.goal(), lacking),
              () -> lackingByGoal.remove(task.goal()));
    } else {
      lackingByGoal.remove(task.goal());
    }
    return result;
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    return planner.revalidate(task, steps);
  }

  /** All obstacles together, if each can be asked for. */
  private Optional<Formula> conditions(PlanningResult.Explanation explanation) {
    List<Formula> conditions = new ArrayList<>();
    for (PlanningResult.Obstacle obstacle : explanation.obstacles()) {
      try {
        Formula condition = SlParser.formula(obstacle.condition(), fluents);
        if (!FreeVariables.of(condition).isEmpty()) {
          return Optional.empty();
        }
        if (!conditions.contains(condition)) {
          conditions.add(condition);
        }
      } catch (SlSyntaxException notInTheLanguage) {
        return Optional.empty();
      }
    }
    if (conditions.isEmpty()) {
      return Optional.empty();
    }
    return Optional.of(conditions.size() == 1 ? conditions.get(0) : new Formula.And(conditions));
  }
}
