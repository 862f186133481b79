package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import org.junit.jupiter.api.Test;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.grounding.Grounder;
import org.maestro.planning.optimal.LandmarkCut;
import org.maestro.planning.optimal.OptimalSearch;
import org.maestro.planning.optimal.RelaxedProblem;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.PlanBuilder;

class GroundingBudgetTest {
  private final OptimalPlanner planner = new OptimalPlanner();

  @Property(tries = 100)
  void aGrowingBudgetFindsWhatAllStepsTogetherGive(@ForAll Random random) {
    PlanningTask task = OptimalityPropertyTest.homeTask(random);
    GroundProblem whole = new Grounder(task).ground();
    OptimalSearch.Outcome expected =
        new OptimalSearch(
                whole,
                new LandmarkCut(new RelaxedProblem(whole)),
                Effort.forAnyPlan(100_000),
                Double.MAX_VALUE)
            .run();

    PlanningResult found = planner.optimistic(task);

    if (expected instanceof OptimalSearch.Outcome.Found best) {
      double cost = PlanBuilder.plan(whole.placed(), best.operators()).cost();
      assertThat(((PlanningResult.Found) found).plan().cost()).isCloseTo(cost, within(1e-9));
    } else {
      assertThat(found).isInstanceOf(PlanningResult.Impossible.class);
    }
  }

  @Property(tries = 100)
  void theCheapestPlanIsFoundWithinItsOwnCost(@ForAll Random random) {
    PlanningTask task = OptimalityPropertyTest.homeTask(random);
    if (planner.optimistic(task) instanceof PlanningResult.Found best) {
      double cost = best.plan().cost() + 1e-9;
      GroundProblem within = new Grounder(task).ground(cost).problem();

      assertThat(
              new OptimalSearch(
                      within,
                      new LandmarkCut(new RelaxedProblem(within)),
                      Effort.forAnyPlan(100_000),
                      cost)
                  .run())
          .isInstanceOf(OptimalSearch.Outcome.Found.class);
    }
  }

  @Test
  void stepsBeyondTheBudgetAreNotMade() {
    SmallWorld world = BobsHome.words().individuals("Zone Place", "zone-a", "zone-b");
    world.individuals("Thing Item", "Cup").facts("(= (illuminance zone-a) 90)");
    BobsHome.camera(world, "cam-a", "zone-a");
    BobsHome.robot(world, "rose", "zone-a", "5");
    Grounder.Grounded grounded = new Grounder(world.task("(canSee ?agent Cup)")).ground(2);

    Set<String> features =
        grounded.problem().operators().stream()
            .map(operator -> operator.feature().type().name())
            .collect(Collectors.toSet());
    assertThat(features).containsExactly("observeObject");
    assertThat(grounded.beyond()).isGreaterThan(2).isFinite();
  }

  /** The one goes from the cup to Bob for 3 in all, the others have to come from further away. */
  @Test
  void whoHasToComeFromTooFarAwayIsNotMadeGround() {
    SmallWorld world = BobsHome.words();
    for (int zone = 0; zone < 12; zone++) {
      world.individuals("Zone Place", "z" + zone);
      if (zone > 0) {
        world.facts("(adjoins z%d z%d)".formatted(zone - 1, zone));
        world.facts("(adjoins z%d z%d)".formatted(zone, zone - 1));
      }
    }
    world.individuals("Thing", "Bob").individuals("Thing Item", "Cup");
    world.facts("(in Bob z6)", "(in Cup z4)", "(= (mass Cup) 0.25)");
    BobsHome.robot(world, "near", "z3", "1");
    BobsHome.robot(world, "far", "z11", "1");
    BobsHome.robot(world, "there", "z6", "1");
    PlanningTask task = world.task("(nextTo Cup Bob)");

    PlanningResult.Found best = (PlanningResult.Found) planner.plan(task);
    GroundProblem problem = new Grounder(task).ground(best.plan().cost()).problem();

    assertThat(best.plan().cost()).isCloseTo(3 + 4 + 3, within(1e-9));
    assertThat(problem.operators())
        .extracting(operator -> operator.feature().member())
        .containsOnly("near");
  }
}
