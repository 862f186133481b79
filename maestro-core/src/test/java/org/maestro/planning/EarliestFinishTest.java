package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.Objective;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Planner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.PlanBuilder;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;

/** Plans that are over first, beside those that are cheapest. */
class EarliestFinishTest {
  private final Planner planner = new OptimalPlanner();

  private static SmallWorld words() {
    return new SmallWorld()
        .word("at", "functional", "?r - Robot", "?p - Place")
        .word("done", "", "?p - Place")
        .word("seen", "observable", "?p - Place")
        .takes("go", "(/ 10 (speed ?self))")
        .takes("work", "(/ 20 (speed ?self))")
        .takes("look", "3")
        .feature(
            "go",
            "to:Place ; from:Place",
            "(and (at ?self ?from) (not (= ?to ?from)))",
            "(at ?self ?to)")
        .feature("work", "; place:Place", "(at ?self ?place)", "(done ?place)")
        .feature("look", "; place:Place", "(unknown (seen ?place))", "(sense (seen ?place))")
        .individuals("Place", "hall", "attic", "cellar");
  }

  private static SmallWorld robot(
      SmallWorld world, String name, double speed, String price, String place) {
    return world
        .individuals("Robot", name)
        .facts("(at " + name + " " + place + ")", "(= (speed " + name + ") " + speed + ")")
        .offer(name, "go", price)
        .offer(name, "work", price);
  }

  private Plan plan(SmallWorld world, String goal, Objective objective) {
    PlanningResult result = planner.plan(world.task(goal).withObjective(objective));
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
    PlanningResult.Found found = (PlanningResult.Found) result;
    assertThat(found.atLeast()).isEmpty();
    return found.plan();
  }

  @Test
  void theSlowRobotIsCheapAndTheFastOneIsThereFirst() {
    SmallWorld world = robot(words(), "slow", 1, "1", "hall");
    robot(world, "fast", 5, "4", "hall");
    Plan cheap = plan(world, "(done attic)", Objective.CHEAPEST);
    assertThat(cheap.steps()).extracting(Step::member).containsOnly("slow");
    assertThat(cheap.cost()).isEqualTo(2);
    assertThat(cheap.seconds()).isEqualTo(30);
    Plan soon = plan(world, "(done attic)", Objective.EARLIEST_FINISH);
    assertThat(soon.steps()).extracting(Step::member).containsOnly("fast");
    assertThat(soon.cost()).isEqualTo(8);
    assertThat(soon.seconds()).isEqualTo(6);
  }

  @Test
  void twoRobotsSideBySideAreDearerAndSooner() {
    SmallWorld world = robot(words(), "one", 1, "1", "attic");
    robot(world, "two", 1, "3", "cellar");
    String goal = "(and (done attic) (done cellar))";
    Plan cheap = plan(world, goal, Objective.CHEAPEST);
    assertThat(cheap.steps()).extracting(Step::member).containsOnly("one");
    assertThat(cheap.cost()).isEqualTo(3);
    assertThat(cheap.seconds()).isEqualTo(50);
    Plan soon = plan(world, goal, Objective.EARLIEST_FINISH);
    assertThat(soon.steps()).extracting(Step::member).containsExactlyInAnyOrder("one", "two");
    assertThat(soon.cost()).isEqualTo(4);
    assertThat(soon.seconds()).isEqualTo(20);
  }

  @Test
  void whoeverIsNotNeededForLookingWaitsForIt() {
    SmallWorld world = robot(words(), "one", 1, "1", "hall");
    world.individuals("Camera", "eye").offer("eye", "look", "1");
    Plan soon = plan(world, "(and (done attic) (seen cellar))", Objective.EARLIEST_FINISH);
    assertThat(soon.seconds()).isEqualTo(3 + 10 + 20);
  }

  @Test
  void whenTheSearchIsBrokenOffItSaysWhatIsSure() {
    SmallWorld world = robot(words(), "one", 1, "1", "attic");
    robot(world, "two", 1, "3", "cellar");
    String goal = "(and (done attic) (done cellar) (done hall))";
    PlanningResult result =
        new OptimalPlanner(60).plan(world.task(goal).withObjective(Objective.EARLIEST_FINISH));
    PlanningResult.Found found = (PlanningResult.Found) result;
    double best = plan(world, goal, Objective.EARLIEST_FINISH).seconds();
    if (found.atLeast().isPresent()) {
      assertThat(found.atLeast().getAsDouble()).isLessThanOrEqualTo(best);
      assertThat(found.plan().seconds()).isGreaterThanOrEqualTo(best);
    } else {
      assertThat(found.plan().seconds()).isEqualTo(best);
    }
  }

  /** Small enough to try all sequences of steps. */
  @Property(tries = 25)
  void noSequenceOfStepsIsOverSooner(@ForAll Random random) {
    List<String> places = List.of("hall", "attic", "cellar");
    SmallWorld world = words();
    robot(world, "one", 1 + random.nextInt(4), "1", places.get(random.nextInt(3)));
    robot(world, "two", 1 + random.nextInt(4), "3", places.get(random.nextInt(3)));
    if (random.nextBoolean()) {
      world.individuals("Camera", "eye").offer("eye", "look", "1");
    }
    String goal =
        List.of(
                "(and (done attic) (done cellar))",
                "(and (done hall) (at one attic))",
                "(and (at one cellar) (at two cellar))",
                "(done cellar)")
            .get(random.nextInt(4));
    if (world.offers.size() > 4) {
      goal = "(and " + goal + " (seen attic))";
    }
    PlanningTask task = world.task(goal).withObjective(Objective.EARLIEST_FINISH);
    GroundProblem problem = Everything.ground(task);
    double[] best = {Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY};
    tryAll(problem, problem.initial(), new ArrayList<>(), 5, best);
    Plan soon = plan(world, goal, Objective.EARLIEST_FINISH);
    assertThat(soon.seconds()).isCloseTo(best[0], within(1e-6));
    assertThat(soon.cost()).isCloseTo(best[1], within(1e-6));
    assertThat(planner.revalidate(task, soon.steps())).isPresent();
  }

  private static void tryAll(
      GroundProblem problem, State state, List<Operator> taken, int left, double[] best) {
    if (problem.goal().condition().holds(state)) {
      Plan plan = PlanBuilder.plan(problem, taken);
      double seconds = plan.seconds();
      if (seconds < best[0] - 1e-9 || seconds < best[0] + 1e-9 && plan.cost() < best[1]) {
        best[0] = seconds;
        best[1] = plan.cost();
      }
    }
    if (left == 0) {
      return;
    }
    for (Operator operator : problem.operators()) {
      if (Successors.isApplicable(operator, state)) {
        State after = Successors.after(operator, state);
        if (after != state) {
          taken.add(operator);
          tryAll(problem, after, taken, left - 1, best);
          taken.remove(taken.size() - 1);
        }
      }
    }
  }
}
