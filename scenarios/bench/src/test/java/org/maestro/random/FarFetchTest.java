package org.maestro.random;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.DescribedFeatures;
import org.maestro.knowledge.CollectiveKnowledge;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.planning.OptimalPlanner;
import org.maestro.planning.ReplanningPlanner;
import org.maestro.planning.api.PlanningResult;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.PricedFeature;
import org.maestro.rats.time.SteppedClock;
import org.maestro.sl.SlParser;

/** A thing that has to go far, among many who could carry it: there is a plan, and soon. */
class FarFetchTest {
  private static final double ROUNDING = 1e-6;

  @Test
  void oneOfManyRobotsCarriesItAndNobodyElseIsLookedForAnyLonger() {
    Building building = new Building(400, 1, 1);
    Home home = new HomeLoader().load(building.homeText(), "building.ttl");
    try (CollectiveKnowledge knowledge = new CollectiveKnowledge(home, new SteppedClock())) {
      building
          .robotRooms()
          .forEach((robot, room) -> state(knowledge, Source.Kind.STATED, robot, in(robot, room)));
      state(knowledge, Source.Kind.OBSERVED, "cam-0", in("Thing0", 0));
      state(knowledge, Source.Kind.OBSERVED, "cam-1", in("Person0", building.rooms() - 1));
      PlanningTask task =
          new PlanningTask(
              home.vocabulary(),
              knowledge.snapshot(),
              priced(home),
              SlParser.formula("(nextTo Thing0 Person0)", home.vocabulary()::isFluent),
              Set.of());
      ReplanningPlanner planner = new ReplanningPlanner(new OptimalPlanner());

      PlanningResult first = planner.solve(task);
      PlanningResult second = planner.solve(task);

      assertThat(first).isInstanceOf(PlanningResult.Found.class);
      PlanningResult.Found found = (PlanningResult.Found) first;
      assertThat(found.plan().members()).hasSize(1);
      assertThat(found.atLeast().orElseThrow())
          .as("not called the cheapest, since that is not proven")
          .isBetween(1.0, found.plan().cost());
      assertThat(found.contenders()).containsAll(found.plan().members());
      assertThat(found.rivals())
          .as("what others would ask is worth asking for")
          .extracting(price -> price.step().member())
          .isNotEmpty()
          .doesNotContainAnyElementsOf(found.plan().members());
      assertThat(((PlanningResult.Found) second).plan().cost())
          .isLessThanOrEqualTo(found.plan().cost() + ROUNDING);
    }
  }

  /** Driving costs what everybody can reckon; only its member knows what grasping costs. */
  private static List<PricedFeature> priced(Home home) {
    Price driving =
        new Price.Stated(SlParser.expression("(* 1.08 (/ (pathLength ?from ?to) (speed ?self)))"));
    List<PricedFeature> priced = new ArrayList<>();
    for (PricedFeature feature : DescribedFeatures.of(home, device -> true)) {
      priced.add(
          feature.type().name().equals("move")
              ? new PricedFeature(feature.member(), feature.type(), driving, Map.of())
              : feature);
    }
    return priced;
  }

  private static void state(
      CollectiveKnowledge knowledge, Source.Kind kind, String source, String fact) {
    knowledge.state(new Source(kind, source), List.of(fact));
  }

  private static String in(String thing, int room) {
    return "(in %s z%d)".formatted(thing, room);
  }
}
