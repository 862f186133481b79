package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import org.junit.jupiter.api.Test;

class TieredPlannerTest {
  private final OptimalPlanner whole = new OptimalPlanner();
  private final Planner optimistic =
      new Planner() {
        @Override
        public PlanningResult plan(PlanningTask task) {
          return whole.optimistic(task);
        }

        @Override
        public Optional<Plan> revalidate(PlanningTask task, List<Step> steps) {
          return whole.revalidate(task, steps);
        }
      };

  @Property(tries = 60, shrinking = ShrinkingMode.OFF)
  void costsWhatPlanningWithAllFeaturesCosts(@ForAll long seed) {
    PlanningTask task = OptimalityPropertyTest.homeTask(new Random(seed));
    PlanningResult expected = optimistic.plan(task);
    PlanningResult found = new TieredPlanner(optimistic).plan(task);
    if (expected instanceof PlanningResult.Found best) {
      assertThat(found).isInstanceOf(PlanningResult.Found.class);
      assertThat(((PlanningResult.Found) found).plan().cost())
          .isCloseTo(best.plan().cost(), within(1e-9));
    } else {
      assertThat(found).isEqualTo(expected);
    }
  }

  @Test
  void leavesOutWhatIsDearerThanThePlan() {
    SmallWorld world = BobsHome.words().individuals("Zone Place", "zone-a", "zone-b");
    world.individuals("Thing Item", "Cup").facts("(= (illuminance zone-a) 90)");
    BobsHome.camera(world, "cam-a", "zone-a");
    BobsHome.robot(world, "rose", "zone-a", "5");
    List<Integer> sizes = new ArrayList<>();
    Planner counting =
        new Planner() {
          @Override
          public PlanningResult plan(PlanningTask asked) {
            sizes.add(asked.features().size());
            return whole.plan(asked);
          }

          @Override
          public Optional<Plan> revalidate(PlanningTask asked, List<Step> steps) {
            return whole.revalidate(asked, steps);
          }
        };
    PlanningTask full = world.task("(canSee ?agent Cup)");

    assertThat(new TieredPlanner(counting).plan(full)).isInstanceOf(PlanningResult.Found.class);
    assertThat(sizes).allSatisfy(size -> assertThat(size).isLessThan(full.features().size()));
  }
}
