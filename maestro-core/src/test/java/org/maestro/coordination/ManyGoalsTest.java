package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Fifty wishes at once over twenty robots. */
class ManyGoalsTest {
  private static final int ZONES = 5;
  private static final int ROBOTS = 20;
  private static final int WISHES = 50;

  private final CarrierPlanner planner = new CarrierPlanner();

  @Test
  void aChangeWakesOnlyThoseWhomItConcerns() {
    NarrowHouse house = new NarrowHouse(home(), 1, planner);
    for (int i = 0; i < ROBOTS; i++) {
      house.with("robot-" + i, "zone-" + i % ZONES);
    }
    for (int i = 0; i < WISHES; i++) {
      house.with("Item" + i, "zone-" + (i * 3) % ZONES);
    }
    for (int i = 0; i < WISHES; i++) {
      house.wish("(in Item%d zone-%d)".formatted(i, (i * 3 + 1) % ZONES));
    }
    house.clock.run(Duration.ofSeconds(5));

    assertThat(house.coordinator.goals())
        .allMatch(
            goal -> goal.state() == GoalState.RUNNING || !goal.waits().isEmpty(),
            "at work or queued");

    assertThat(house.run(WISHES, Duration.ofMinutes(30))).as(house.told()).isTrue();
    assertThat(house.outcomes.values()).allMatch(GoalOutcome::reached);
    assertThat(house.accidents).isEmpty();
    assertThat(planner.plans()).isLessThan(6 * WISHES);
    assertThat(planner.checks()).isLessThan(40 * WISHES);
  }

  private static Home home() {
    StringBuilder turtle =
        new StringBuilder(
            """
            @prefix : <https://w3id.org/maestro/domain#> .
            @prefix home: <https://w3id.org/maestro/home/row#> .
            @prefix maestro: <https://w3id.org/maestro#> .
            @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
            <https://w3id.org/maestro/home/row> a maestro:Home ; rdfs:label "row" .
            """);
    for (int i = 0; i < ZONES; i++) {
      String outline = "%d 0, %d 0, %d 3, %d 3".formatted(3 * i, 3 * i + 3, 3 * i + 3, 3 * i);
      turtle.append(
          """
          home:room-%d a maestro:Room ; maestro:outline "%s" ; maestro:height 2.8 .
          home:zone-%d a maestro:Zone ; maestro:outline "%s" .
          """
              .formatted(i, outline, i, outline));
      if (i > 0) {
        turtle.append(
            """
            home:door-%d a maestro:Door ; maestro:openingFrom "%d 1" ; maestro:openingTo "%d 2" ;
              :side home:zone-%d , home:zone-%d ; :open true .
            """
                .formatted(i, 3 * i, 3 * i, i - 1, i));
      }
    }
    for (int i = 0; i < WISHES; i++) {
      turtle.append(
          "home:Item%d a :Item ; :colour \"red\" ; :size \"0.1 0.1 0.1\" ; :mass 0.2 .\n"
              .formatted(i));
    }
    for (int i = 0; i < ROBOTS; i++) {
      turtle.append(
          """
          home:robot-%d a :MobileRobot ; maestro:order %d ; :colour "grey" ;
            :size "0.5 0.4 0.4" ; :speed 0.8 ; :payload 0.5 .
          """
              .formatted(i, i + 1));
    }
    return new HomeLoader().load(turtle.toString(), "row.ttl");
  }
}
