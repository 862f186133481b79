package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;

/**
 * A larger hall: three zones, three cameras, six lamps with four levels that all shine into every
 * zone.
 */
class ArenaPlanningTest {
  private final OptimalPlanner planner = new OptimalPlanner();

  static SmallWorld arena() {
    SmallWorld world =
        BobsHome.words()
            .individuals("Zone Place", "zone-1", "zone-2", "zone-3")
            .individuals("Thing Item", "GreenObject", "RedObject1", "RedObject2")
            .facts("(= (mass GreenObject) 0.2)", "(= (mass RedObject1) 0.2)")
            .facts("(= (mass RedObject2) 0.2)");
    for (int i = 1; i <= 2; i++) {
      world.facts("(adjoins zone-" + i + " zone-" + (i + 1) + ")");
      world.facts("(adjoins zone-" + (i + 1) + " zone-" + i + ")");
    }
    for (int i = 1; i <= 3; i++) {
      BobsHome.camera(world, "cam-" + i, "zone-" + i);
    }
    BobsHome.sensor(world, "lux-1", "zone-2");
    world.feature(
        "adjustLight",
        "level=0,0.25,0.5,1",
        "(not (= (level ?self) ?level))",
        "(and (assign (level ?self) ?level) (forall (?z - Zone) (when (> (gain ?self ?z) 0)"
            + " (increase (illuminance ?z) (* (gain ?self ?z) (- ?level (level ?self)))))))");
    double[][] gains = {
      {30, 12, 2}, {28, 14, 3}, {14, 30, 12}, {12, 31, 14}, {3, 13, 29}, {2, 12, 32}
    };
    for (int i = 0; i < 6; i++) {
      String name = "lamp-" + (i + 1);
      world.facts("(= (power " + name + ") " + (8 + i) + ")");
      String price = "(+ 0.3 (* 0.1 (power ?self) (max 0 (- ?level (level ?self)))))";
      BobsHome.lamp(
          world,
          name,
          0,
          price,
          "(= (gain " + name + " zone-1) " + gains[i][0] + ")",
          "(= (gain " + name + " zone-2) " + gains[i][1] + ")",
          "(= (gain " + name + " zone-3) " + gains[i][2] + ")");
    }
    BobsHome.robot(world, "rose", "zone-1", "5");
    return world;
  }

  @Test
  void findsCheapestPlansAndPrintsItsTime() {
    SmallWorld dark =
        arena()
            .facts("(= (illuminance zone-1) 5)", "(= (illuminance zone-2) 5)")
            .facts("(= (illuminance zone-3) 5)");
    SmallWorld searched =
        arena()
            .facts("(= (illuminance zone-1) 5)", "(= (illuminance zone-2) 5)")
            .facts("(= (illuminance zone-3) 5)", "(not (in GreenObject zone-1))")
            .facts("(not (in GreenObject zone-2))", "(not (in RedObject1 zone-1))");
    time("seen, light unknown", arena(), "(canSee ?agent GreenObject)");
    time("seen, dark", dark, "(canSee ?agent GreenObject)");
    time("brought, dark", dark, "(nextTo GreenObject RedObject1)");
    time("brought, searched", searched, "(nextTo GreenObject RedObject1)");
    time(
        "all bright",
        dark,
        "(and (>= (illuminance zone-1) 50) (>= (illuminance zone-2) 50) (>= (illuminance zone-3)"
            + " 50))");
  }

  private void time(String name, SmallWorld world, String goal) {
    PlanningTask task = world.task(goal);
    long first = System.nanoTime();
    PlanningResult result = planner.plan(task);
    long cold = System.nanoTime() - first;
    assertThat(result).isInstanceOf(PlanningResult.Found.class);
    int runs = 5;
    long start = System.nanoTime();
    for (int i = 0; i < runs; i++) {
      planner.plan(task);
    }
    System.out.printf(
        "arena, %s: cost %.2f, first %.1f ms, then %.2f ms%n",
        name,
        ((PlanningResult.Found) result).plan().cost(),
        cold / 1e6,
        (System.nanoTime() - start) / 1e6 / runs);
  }
}
