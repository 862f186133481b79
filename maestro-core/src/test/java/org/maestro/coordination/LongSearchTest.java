package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.Term;

/** A thing may be anywhere in a house of many rooms. */
class LongSearchTest {
  /** More than a goal may be planned for in vain. */
  private static final int ROOMS = 64;

  /** By name, which decides among rooms that are all alike. */
  private static final int LAST = 9;

  @Test
  void aThingInTheRoomThatIsLookedAtLastIsFound() {
    PretendHouse house = lit();
    house.made.put(
        "observeObject cam-" + LAST,
        step ->
            PretendHouse.succeeded(
                Map.of(
                    "found",
                    new Term.Truth(true),
                    "pose",
                    new Term.Text("%d 1 0".formatted(3 * LAST + 1)))));

    GoalOutcome outcome = house.achieve("(in Cup ?where)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.binding()).containsEntry("where", new Term.Name("zone-" + LAST));
    assertThat(house.calls).hasSize(ROOMS);
  }

  @Test
  void aThingInNoneOfThemIsGivenUpWithAllThatWereLookedAt() {
    GoalOutcome outcome = lit().achieve("(in Cup ?where)");

    assertThat(outcome.reached()).isFalse();
    assertThat(String.join(" ", outcome.reasons()))
        .doesNotContain("times without getting there")
        .contains("in zone-0 by cam-0", "in zone-%d by cam-%d".formatted(ROOMS - 1, ROOMS - 1));
  }

  private static PretendHouse lit() {
    PretendHouse house = new PretendHouse(home());
    house.place.put("Cup", "nowhere");
    for (int room = 0; room < ROOMS; room++) {
      house.ambientLux.put("zone-" + room, 100.0);
      house.knowledge.state(
          new Source(Source.Kind.OBSERVED, "somebody"),
          List.of("(= (illuminance zone-%d) 100)".formatted(room)));
    }
    return house;
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
            home:Cup a :Item ; :colour "red" ; :size "0.1 0.1 0.1" ; :mass 0.2 .
            """);
    for (int room = 0; room < ROOMS; room++) {
      int x = 3 * room;
      turtle.append(
          """
          home:room-%1$d a maestro:Room ; maestro:outline "%2$d 0, %3$d 0, %3$d 3, %2$d 3" ;
            maestro:height 2.8 .
          home:zone-%1$d a maestro:Zone ; maestro:outline "%2$d 0, %3$d 0, %3$d 3, %2$d 3" .
          home:cam-%1$d a :Camera ; maestro:pose "%4$d.5 1.5 2.8" ; maestro:viewAngle 110 ;
            :minimumIlluminance 72 ; :maximumIlluminance 2000 .
          """
              .formatted(room, x, x + 3, x + 1));
    }
    return new HomeLoader().load(turtle.toString(), "row.ttl");
  }
}
