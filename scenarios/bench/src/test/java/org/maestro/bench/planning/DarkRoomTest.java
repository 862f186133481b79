package org.maestro.bench.planning;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Set;
import org.assertj.core.data.Offset;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.DescribedFeatures;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.random.Building;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/** In a building of many rooms alike, one turns out to be dark. */
class DarkRoomTest {
  private static final Offset<Double> ROUNDING = Offset.offset(1e-9);

  private final Building building = new Building(100, 1, 1);
  private final Home home = new HomeLoader().load(building.homeText(), "building.ttl");
  private final ReplanningPlanner planner = new ReplanningPlanner(new OptimalPlanner());

  /** Where a robot is already; a room without one is no cheaper to look into, and dearer after. */
  @Test
  void theSearchGoesOnWhereTheRestIsCheapestToo() {
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      building
          .robotRooms()
          .forEach(
              (robot, room) ->
                  knowledge.state(
                      new Source(Source.Kind.STATED, robot),
                      List.of("(in %s z%d)".formatted(robot, room))));
      Plan first = plan(knowledge);
      String dark = first.searches().get(0).places().get(0).value().toString();
      int room = Integer.parseInt(dark.replaceAll("\\D", ""));

      knowledge.state(
          new Source(Source.Kind.OBSERVED, "lux-" + room),
          List.of("(= (illuminance z%d) 17)".formatted(room)));
      Plan second = plan(knowledge);

      assertThat(second.searches().get(0).places().get(0).value().toString()).isNotEqualTo(dark);
      assertThat(second.cost()).isCloseTo(first.cost(), ROUNDING);
      assertThat(second.steps()).noneMatch(step -> step.feature().name().equals("move"));
    }
  }

  private Plan plan(CollectiveKnowledge knowledge) {
    PlanningResult result =
        planner.plan(
            new PlanningTask(
                home.vocabulary(),
                knowledge.snapshot(),
                DescribedFeatures.of(home, device -> true),
                SlParser.formula("(nextTo Thing0 Person0)"),
                Set.of()));
    return ((PlanningResult.Found) result).plan();
  }
}
