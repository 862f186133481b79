package org.maestro.planning;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.ShrinkingMode;
import net.jqwik.api.Tag;

/**
 * Rooms in a row and robots that could do each other's work, who leave and join while things are
 * elsewhere each time: what is kept, and what is not even made because it looks too dear, costs no
 * plan. Compared with a search over all instances that there can be.
 */
class ManyRobotsTest {
  private static final int HAPPENINGS = 4;
  private static final List<String> ZONES = List.of("zone-a", "zone-b", "zone-c", "zone-d");
  private static final List<String> ROBOTS = List.of("rose", "rob", "ray");
  private static final List<String> GOALS =
      List.of(
          "(nextTo Cup Bob)",
          "(in Cup zone-c)",
          "(in Cup rob)",
          "(and (nextTo Cup Bob) (in rose zone-a))",
          "(and (in Cup zone-d) (not (in rose zone-d)))",
          "(and (in Cup zone-a) (in Jug zone-b))",
          "(and (nextTo Jug Bob) (nextTo Cup Bob))",
          "(or (nextTo Jug Cup) (in Bob rose))");

  @Property(tries = 12, shrinking = ShrinkingMode.OFF)
  void leaveAndJoin(@ForAll long seed) {
    Random random = new Random(seed);
    SmallWorld world = home(random);
    List<PricedFeature> all = List.copyOf(world.offers);
    ReplanningPlanner planner = new ReplanningPlanner(new OptimalPlanner(100_000));
    String goal = GOALS.get(random.nextInt(GOALS.size()));
    PlanningTask task = world.task(goal);
    for (int n = 0; n < HAPPENINGS; n++) {
      PlanningResult result = planner.solve(task);
      OptimalSearch.Outcome expected = cheapest(Everything.ground(task), Double.MAX_VALUE);
      if (expected instanceof OptimalSearch.Outcome.Found best) {
        double cost = cost(best);
        assertThat(((PlanningResult.Found) result).plan().cost()).isCloseTo(cost, within(1e-6));
        double budget = cost + 1e-6;
        assertThat(cheapest(new Grounder(task).ground(budget).problem(), budget))
            .as("what is made within the cost of the cheapest plan suffices for it")
            .isInstanceOf(OptimalSearch.Outcome.Found.class);
      } else {
        assertThat(result).isInstanceOf(PlanningResult.Impossible.class);
      }
      if (random.nextInt(3) == 0) {
        world = world.copy();
        world.facts("(in " + any(ROBOTS, random) + " " + any(ZONES, random) + ")");
        task = task.withFacts(world);
      }
      List<PricedFeature> there = new ArrayList<>(all);
      if (random.nextInt(4) > 0) {
        String gone = any(ROBOTS, random);
        there.removeIf(feature -> feature.member().equals(gone));
      }
      task = task.withFeatures(there);
    }
  }

  @Tag("full")
  @Property(tries = 1_000, shrinking = ShrinkingMode.OFF)
  void leaveAndJoinOften(@ForAll long seed) {
    leaveAndJoin(seed);
  }

  private static OptimalSearch.Outcome cheapest(GroundProblem problem, double mostCost) {
    RelaxedProblem relaxed = new RelaxedProblem(problem);
    return new OptimalSearch(
            problem, new LandmarkCut(relaxed), Effort.forAnyPlan(200_000), mostCost)
        .run();
  }

  private static double cost(OptimalSearch.Outcome.Found best) {
    return best.operators().stream()
        .mapToDouble(o -> ((NumberExpression.Constant) o.price().cost()).number())
        .sum();
  }

  private static SmallWorld home(Random random) {
    SmallWorld world = BobsHome.words();
    ZONES.forEach(zone -> world.individuals("Zone Place", zone));
    world.individuals("Thing", "Bob").individuals("Thing Item", "Cup", "Jug");
    world.facts("(= (mass Cup) 0.25)", "(= (mass Jug) " + random.nextInt(2) + ")");
    for (int i = 0; i + 1 < ZONES.size(); i++) {
      String door = "door-" + i;
      world
          .individuals("Door", door)
          .facts("(side " + door + " " + ZONES.get(i) + ")")
          .facts("(side " + door + " " + ZONES.get(i + 1) + ")")
          .offer(door, "openDoor", String.valueOf(random.nextInt(3)));
      if (random.nextInt(4) > 0) {
        world.facts("(open " + door + ")");
      }
    }
    for (String robot : ROBOTS) {
      BobsHome.robot(world, robot, any(ZONES, random), String.valueOf(1 + random.nextInt(6)));
    }
    for (String thing : List.of("Bob", "Cup", "Jug")) {
      world.facts("(in " + thing + " " + any(ZONES, random) + ")");
    }
    if (random.nextInt(3) == 0) {
      world.facts("(in Jug " + any(ROBOTS, random) + ")");
    }
    return world;
  }

  private static <T> T any(List<T> list, Random random) {
    return list.get(random.nextInt(list.size()));
  }
}
