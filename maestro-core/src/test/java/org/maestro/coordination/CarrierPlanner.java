package org.maestro.coordination;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.coordination.facts.ProgressedState;
import org.maestro.coordination.facts.Unfolding;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.planning.api.Step;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * Knows only how the nearest robot with a free hand carries an item along a row of zones, and is
 * fast at it: for tests of how often plans are made and looked at.
 */
final class CarrierPlanner implements Planner {
  private int plans;
  private int checks;

  int plans() {
    return plans;
  }

  int checks() {
    return checks;
  }

  @Override
  public PlanningResult plan(PlanningTask task) {
    plans++;
    if (!(task.goal() instanceof Formula.Atom goal)) {
      return new PlanningResult.GaveUp("nobody can carry it");
    }
    if (task.facts().truth(goal) == Truth.TRUE) {
      return new PlanningResult.Found(new Plan(List.of(), 0, Map.of()));
    }
    Term item = goal.arguments().get(0);
    int from = zone(item, task.facts());
    int to = number(goal.arguments().get(1));
    return task.features().stream()
        .filter(feature -> feature.type().name().equals("pick"))
        .map(PricedFeature::member)
        .filter(robot -> isFree(robot, task.facts()) && from >= 0)
        .min(
            Comparator.comparing(
                robot -> Math.abs(zone(new Term.Name(robot), task.facts()) - from)))
        .<PlanningResult>map(robot -> new PlanningResult.Found(carry(task, robot, item, from, to)))
        .orElse(new PlanningResult.GaveUp("nobody can carry it"));
  }

  private static boolean isFree(String robot, Facts facts) {
    return facts.truth(new Formula.Atom("handFree", List.of(new Term.Name(robot)))) == Truth.TRUE;
  }

  private static int zone(Term thing, Facts facts) {
    return facts.individuals("Zone").stream()
        .filter(zone -> facts.truth(new Formula.Atom("in", List.of(thing, zone))) == Truth.TRUE)
        .mapToInt(CarrierPlanner::number)
        .findFirst()
        .orElse(-1);
  }

  private static int number(Term zone) {
    String name = ((Term.Name) zone).text();
    return Integer.parseInt(name.substring(name.indexOf('-') + 1));
  }

  private static Plan carry(PlanningTask task, String robot, Term item, int from, int to) {
    List<Step> steps = new ArrayList<>();
    drive(task, robot, zone(new Term.Name(robot), task.facts()), from, steps);
    steps.add(step(task, robot, "pick", Map.of("object", item, "zone", place(from)), steps.size()));
    drive(task, robot, from, to, steps);
    steps.add(
        step(
            task,
            robot,
            "place",
            Map.of("object", item, "target", place(to), "zone", place(to)),
            steps.size()));
    return new Plan(steps, steps.stream().mapToDouble(Step::cost).sum(), Map.of());
  }

  private static void drive(PlanningTask task, String robot, int from, int to, List<Step> steps) {
    int at = from;
    while (at != to) {
      int next = at + Integer.signum(to - at);
      steps.add(
          step(task, robot, "move", Map.of("from", place(at), "to", place(next)), steps.size()));
      at = next;
    }
  }

  private static Term place(int number) {
    return new Term.Name("zone-" + number);
  }

  private static Step step(
      PlanningTask task, String robot, String feature, Map<String, Term> bindings, int before) {
    PricedFeature offered =
        task.features().stream()
            .filter(f -> f.member().equals(robot) && f.type().name().equals(feature))
            .findFirst()
            .orElseThrow();
    return new Step(
        before + 1,
        robot,
        offered.type(),
        bindings,
        4,
        4,
        true,
        before == 0 ? Set.of() : Set.of(before));
  }

  @Override
  public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
    checks++;
    Unfolding unfolding = new Unfolding(task.vocabulary());
    Facts facts = task.facts();
    for (Step step : steps) {
      Evaluation now = new Evaluation(facts);
      if (unfolding.conjuncts(step.feature().precondition(), step.values()).stream()
          .anyMatch(condition -> now.truth(condition, Map.of()) == Truth.FALSE)) {
        return Optional.empty();
      }
      facts =
          new ProgressedState(
              facts, now.changes(step.feature().effect(), step.values()), task.vocabulary());
    }
    return new Evaluation(facts).truth(task.goal(), Map.of()) == Truth.TRUE
        ? Optional.of(new Plan(steps, steps.stream().mapToDouble(Step::cost).sum(), Map.of()))
        : Optional.empty();
  }
}
