package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** The plans of the design's worked example, with its costs. */
class BobsCupPlanningTest {
  private static final String GOAL = "(nextTo Cup Bob)";
  private final OptimalPlanner planner = new OptimalPlanner();

  private Plan plan(SmallWorld world, String goal) {
    PlanningTask task = world.task(goal);
    PlanningResult result = planner.plan(task);
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
    Plan plan = ((PlanningResult.Found) result).plan();
    assertThat(planner.revalidate(task, plan.steps()))
        .hasValueSatisfying(again -> assertThat(again.cost()).isEqualTo(plan.cost()));
    return plan;
  }

  private static List<String> texts(Plan plan) {
    return plan.steps().stream()
        .map(
            step ->
                step.member()
                    + " "
                    + step.feature().name()
                    + step.bindings().values().stream()
                        .map(value -> " " + SlPrinter.print(value))
                        .reduce("", String::concat))
        .toList();
  }

  @Test
  void optimismPutsEverythingWhereTheRobotIs() {
    Plan plan = plan(BobsHome.dark(), GOAL);
    assertThat(plan.cost()).isEqualTo(12);
    assertThat(texts(plan))
        .containsExactlyInAnyOrder(
            "lux-b measureIllumination zone-b",
            "cam-b observeObject Bob zone-b",
            "cam-b observeObject Cup zone-b",
            "rose pick Cup zone-b",
            "rose place Cup Bob zone-b");
  }

  @Test
  void theCheapestLampsReachTheThreshold() {
    Plan plan = plan(BobsHome.dark().facts("(= (illuminance zone-b) 17)"), GOAL);
    assertThat(plan.cost()).isEqualTo(14);
    assertThat(texts(plan)).contains("lamp-b1 adjustLight 1", "lamp-b2 adjustLight 1").hasSize(6);
  }

  @Test
  void theRobotCarriesTheCupToTheOtherRoom() {
    SmallWorld world =
        BobsHome.dark()
            .facts("(= (illuminance zone-b) 82)", "(not (in Bob zone-b))")
            .facts("(= (level lamp-b1) 1)", "(= (level lamp-b2) 1)");
    assertThat(plan(world, GOAL).cost()).isEqualTo(17);
    assertThat(plan(world.facts("(= (illuminance zone-a) 92)"), GOAL).cost()).isEqualTo(16);
  }

  @Test
  void aCameraSeesTheCupOnlyWhenItIsCarriedThere() {
    SmallWorld world = BobsHome.dark().facts("(= (illuminance zone-a) 92)", "(in Cup zone-b)");
    Plan plan = plan(world, "(canSee cam-a Cup)");
    assertThat(plan.cost()).isEqualTo(14);
    assertThat(texts(plan))
        .containsExactly(
            "rose pick Cup zone-b",
            "rose move zone-a zone-b",
            "rose place Cup zone-a zone-a",
            "cam-a observeObject Cup zone-a");
  }

  @Test
  void aFreeVariableIsBoundInTheAnswer() {
    SmallWorld world = BobsHome.dark().facts("(= (illuminance zone-b) 100)");
    Plan plan = plan(world, "(canSee ?agent Cup)");
    assertThat(plan.cost()).isEqualTo(2);
    assertThat(plan.goalBinding()).containsEntry("agent", new Term.Name("cam-b"));
  }

  @Test
  void aGoalThatHoldsNeedsNoStep() {
    Plan plan = plan(BobsHome.dark().facts("(nextTo Bob Cup)"), GOAL);
    assertThat(plan.steps()).isEmpty();
    assertThat(plan.cost()).isZero();
  }

  @Test
  void lampsInParallelThenTheCamera() {
    Plan plan = plan(BobsHome.dark().facts("(= (illuminance zone-b) 17)"), "(canSee cam-b Cup)");
    assertThat(plan.cost()).isEqualTo(5);
    assertThat(plan.steps().get(0).after()).isEmpty();
    assertThat(plan.steps().get(1).after()).isEmpty();
    assertThat(plan.steps().get(2).after()).containsExactly(1, 2);
  }

  @Test
  void planningAgainGivesTheSamePlan() {
    SmallWorld[] worlds = {
      BobsHome.dark(),
      BobsHome.dark().facts("(= (illuminance zone-b) 17)"),
      BobsHome.dark().facts("(= (illuminance zone-b) 17)", "(not (in Bob zone-b))")
    };
    for (SmallWorld world : worlds) {
      BobsHome.robot(world, "tim", "zone-a", "8");
      PlanningTask task = world.task(GOAL);

      PlanningResult first = planner.plan(task);

      assertThat(first).isInstanceOf(PlanningResult.Found.class);
      assertThat(planner.plan(task)).isEqualTo(first);
      assertThat(new OptimalPlanner().plan(task)).isEqualTo(first);
    }
  }
}
