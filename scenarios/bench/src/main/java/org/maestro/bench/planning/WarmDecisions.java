package org.maestro.bench.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.stream.IntStream;
import org.maestro.coordination.api.DescribedFeatures;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.random.Building;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/**
 * Decisions of a planner that runs, as in a platform: what no goal changes is known from goals
 * before, each goal is a new one.
 */
final class WarmDecisions {
  /** What is known of a building in which a platform runs. */
  enum Known {
    NOTHING("nothing known"),
    DEVICES("devices have told how they are"),
    ALL("all known");

    private final String words;

    Known(String words) {
      this.words = words;
    }

    String words() {
      return words;
    }
  }

  /** Decided before the first that counts. */
  private static final int WARM_UP = 3;

  private static final int GOALS = 9;

  private final Building building;
  private final Home home;

  WarmDecisions(Building building) {
    this.building = building;
    this.home = new HomeLoader().load(building.homeText(), "building.ttl");
  }

  /**
   * The median of a decision.
   *
   * @param goals different ones, used again when there are not enough
   * @return seconds
   */
  double median(Known known, List<String> goals) {
    List<PricedFeature> features = DescribedFeatures.of(home, device -> true);
    ReplanningPlanner planner = new ReplanningPlanner(new OptimalPlanner());
    List<Double> seconds = new ArrayList<>();
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      tell(knowledge, known);
      for (int goal = 0; goal < WARM_UP + GOALS; goal++) {
        PlanningTask task =
            new PlanningTask(
                home.vocabulary(),
                knowledge.snapshot(),
                features,
                SlParser.formula(goals.get(goal % goals.size()), home.vocabulary()::isFluent),
                Set.of());
        long begin = System.nanoTime();
        PlanningResult result = planner.plan(task);
        seconds.add((System.nanoTime() - begin) / 1e9);
        if (!(result instanceof PlanningResult.Found)) {
          throw new IllegalStateException("No plan for " + task.goal() + ": " + result);
        }
      }
    }
    return seconds.stream().skip(WARM_UP).sorted().skip(GOALS / 2).findFirst().orElseThrow();
  }

  private void tell(CollectiveKnowledge knowledge, Known known) {
    if (known != Known.NOTHING) {
      building.robotRooms().forEach((robot, room) -> told(knowledge, robot, in(robot, room)));
      for (Device device : home.devices().values()) {
        if (device.tells("level")) {
          told(knowledge, device.id(), "(= (level %s) 0)".formatted(device.id()));
        }
      }
    }
    if (known == Known.ALL) {
      for (Map.Entry<String, Integer> thing : building.thingRooms().entrySet()) {
        knowledge.state(
            new Source(Source.Kind.OBSERVED, "cam-" + thing.getValue()),
            List.of(in(thing.getKey(), thing.getValue())));
      }
      IntStream.range(0, building.rooms())
          .forEach(
              room ->
                  knowledge.state(
                      new Source(Source.Kind.OBSERVED, "lux-" + room),
                      List.of("(= (illuminance z%d) 110)".formatted(room))));
    }
  }

  private static void told(CollectiveKnowledge knowledge, String device, String fact) {
    knowledge.state(new Source(Source.Kind.STATED, device), List.of(fact));
  }

  private static String in(String thing, int room) {
    return "(in %s z%d)".formatted(thing, room);
  }
}
