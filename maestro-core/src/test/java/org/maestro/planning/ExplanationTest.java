package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.planning.PlanningResult.Obstacle;
import org.maestro.sl.Term;

/** Why there is no plan. */
class ExplanationTest {
  private static final String GOAL = "(nextTo Cup Bob)";

  private static List<Obstacle> obstacles(PlanningTask task) {
    PlanningResult result = new OptimalPlanner().plan(task);
    assertThat(result).isInstanceOf(PlanningResult.Impossible.class);
    return ((PlanningResult.Impossible) result).explanation().obstacles();
  }

  @Test
  void namesTheLightThatNoLampCanGive() {
    SmallWorld world =
        BobsHome.dark()
            .withdraw("lamp-b1")
            .withdraw("lamp-b2")
            .facts("(= (illuminance zone-b) 17)", "(= (illuminance zone-a) 92)")
            .facts("(in Bob zone-a)", "(not (in Cup zone-a))");
    assertThat(obstacles(world.task(GOAL)))
        .containsExactly(
            new Obstacle(
                "(>= (illuminance zone-b) 72)", ">= 72", "42", "cam-b does observeObject"));
  }

  @Test
  void namesThePlacesThatWereSearched() {
    SmallWorld world =
        BobsHome.dark()
            .facts("(in Bob zone-a)", "(not (in Cup zone-a))", "(not (in Cup zone-b))")
            .facts("(= (illuminance zone-b) 100)", "(= (illuminance zone-a) 92)");
    assertThat(obstacles(world.task(GOAL)))
        .singleElement()
        .satisfies(
            obstacle -> {
              assertThat(obstacle.condition()).startsWith("(in Cup ");
              assertThat(obstacle.possible()).isEqualTo("looked in zone-a, zone-b; excluded");
            });
  }

  @Test
  void namesTheWeightThatIsTooMuch() {
    SmallWorld world = BobsHome.dark().facts("(= (mass Cup) 0.75)");
    assertThat(obstacles(world.task(GOAL)))
        .containsExactly(
            new Obstacle("(<= (mass Cup) (payload rose))", "<= 0.5", "0.75", "rose does pick"));
  }

  @Test
  void namesWhatNobodyChanges() {
    SmallWorld world = BobsHome.dark().withdraw("rose");
    assertThat(obstacles(world.task(GOAL)))
        .containsExactly(
            new Obstacle("(nextTo Cup Bob)", "true", "no agent can change it", "the goal"));
    assertThat(obstacles(BobsHome.dark().task("(adjoins zone-a zone-b)")))
        .containsExactly(
            new Obstacle("(adjoins zone-a zone-b)", "true", "no agent can change it", "the goal"));
  }

  @Test
  void namesTheStepThatIsBarred() {
    SmallWorld world = BobsHome.dark();
    PlanningTask task = world.task("(canSee cam-b Cup)");
    StepKey key =
        new StepKey(
            "cam-b",
            "observeObject",
            Map.of("object", new Term.Name("Cup"), "zone", new Term.Name("zone-b")));
    PlanningTask barred =
        new PlanningTask(
            task.vocabulary(), task.facts(), task.features(), task.goal(), Set.of(key));
    assertThat(obstacles(barred))
        .singleElement()
        .satisfies(
            obstacle ->
                assertThat(obstacle.possible())
                    .isEqualTo("declined, or failed twice with the same facts"));
  }

  @Test
  void saysWhenTheBoundWasReached() {
    PlanningTask task = BobsHome.dark().facts("(= (illuminance zone-b) 17)").task(GOAL);
    assertThat(new OptimalPlanner(2).plan(task)).isInstanceOf(PlanningResult.GaveUp.class);
  }
}
