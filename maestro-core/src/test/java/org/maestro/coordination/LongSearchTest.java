package org.maestro.coordination;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Stakes;
import org.maestro.knowledge.api.Source;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sl.Expression;
import org.maestro.sl.SlParser;
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
    foundIn(house, LAST);

    GoalOutcome outcome = house.achieve("(in Cup ?where)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.binding()).containsEntry("where", new Term.Name("zone-" + LAST));
    assertThat(house.calls).hasSize(ROOMS);
  }

  @Test
  void asManyLooksAtOnceAsWereInVain() {
    PretendHouse house = lit();
    List<Integer> inVain = new ArrayList<>();
    List<Integer> atOnce = new ArrayList<>();
    int[] begun = new int[1];
    int[] ended = new int[1];
    house.ordered =
        order -> {
          begun[0]++;
          inVain.add(ended[0]);
          atOnce.add(begun[0] - ended[0]);
        };
    house.beforeCall = call -> ended[0]++;

    house.achieve("(in Cup ?where)");

    assertThat(begun[0]).isEqualTo(ROOMS);
    for (int look = 0; look < begun[0]; look++) {
      assertThat(atOnce.get(look)).isLessThanOrEqualTo(1 + Math.min(16, inVain.get(look)));
    }
    assertThat(atOnce).contains(16);
    assertThat(house.clock.now()).isLessThan(house.stepTakes.multipliedBy(ROOMS / 4));
  }

  @Test
  void whatIsFoundEndsTheOtherLooks() {
    PretendHouse house = lit();
    foundIn(house, 40);

    GoalOutcome outcome = house.achieve("(in Cup ?where)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(outcome.binding()).containsEntry("where", new Term.Name("zone-40"));
    assertThat(outcome.calls()).isLessThan(10);
    house.clock.run(Duration.ofMinutes(1));
    assertThat(house.calls).hasSizeLessThan(ROOMS + 1);
    assertThat(house.coordinator.isAtWork()).isFalse();
    assertThat(house.coordinator.waits()).isEmpty();
  }

  @Test
  void aFewRoomsAreLookedAtOneAfterTheOther() {
    PretendHouse house = lit(8);
    int[] underway = new int[1];
    List<Integer> atOnce = new ArrayList<>();
    house.ordered = order -> atOnce.add(++underway[0]);
    house.beforeCall = call -> underway[0]--;

    house.achieve("(in Cup ?where)");

    assertThat(atOnce).hasSize(8).containsOnly(1);
  }

  @Test
  void whereTimeHasAPriceTheyAreLookedAtAtOnce() {
    PretendHouse house = lit(8);
    int[] underway = new int[1];
    List<Integer> atOnce = new ArrayList<>();
    house.ordered = order -> atOnce.add(++underway[0]);
    house.beforeCall = call -> underway[0]--;
    List<GoalOutcome> outcome = new ArrayList<>();

    house.coordinator.submit(
        new GoalRequest(SlParser.formula("(in Cup ?where)"), "Bob")
            .with(
                new Stakes(new Expression.OfTerm(new Term.Number(600)))
                    .allowed(Duration.ofMinutes(1))),
        outcome::add);
    house.clock.runUntil(() -> !outcome.isEmpty(), Duration.ofMinutes(10));

    assertThat(atOnce).hasSize(8).contains(8);
  }

  @Test
  void aLookThatFailsIsTriedByThePlan() {
    PretendHouse house = lit();
    int[] tries = new int[1];
    house.made.put(
        "observeObject cam-40",
        step -> ++tries[0] == 1 ? PretendHouse.failed("blinded", List.of()) : found(40));

    GoalOutcome outcome = house.achieve("(in Cup ?where)");

    assertThat(outcome.reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(tries[0]).isEqualTo(2);
  }

  /** Also the one that is over while the plan is made that left its place out. */
  @ParameterizedTest
  @ValueSource(ints = {20, 130, 260, 510, 900})
  void whicheverLookFailsItIsNotCalledImpossible(int planningMillis) {
    for (int rooms = 9; rooms < 13; rooms++) {
      for (int failing = 0; failing < rooms; failing++) {
        PretendHouse house = lit(rooms);
        house.planningTakes = Duration.ofMillis(planningMillis);
        int room = failing;
        int[] tries = new int[1];
        house.made.put(
            "observeObject cam-" + room,
            step -> ++tries[0] == 1 ? PretendHouse.failed("blinded", List.of()) : found(room));

        GoalOutcome outcome = house.achieve("(in Cup ?where)");

        assertThat(outcome.reached())
            .as("%d of %d: %s", room, rooms, String.join("\n", house.story))
            .isTrue();
      }
    }
  }

  @Test
  void theStoryTellsOfThem() {
    PretendHouse house = lit();

    house.achieve("(in Cup ?where)");

    assertThat(String.join("\n", house.story))
        .contains("[0.1] Looks meanwhile whether Cup is in zone-")
        .contains("[0.1] cam-")
        .contains("looks beside each other");
  }

  @Test
  void aRestartAmongManyLooksDoesNoneTwiceForNothing() {
    PretendHouse house = lit();
    foundIn(house, 60);
    List<GoalOutcome> outcome = new ArrayList<>();
    house.coordinator.submit(
        new GoalRequest(SlParser.formula("(in Cup ?where)"), "Bob"), outcome::add);
    house.clock.runUntil(() -> house.calls.size() > 20, Duration.ofMinutes(10));

    house.restart(outcome::add);
    house.clock.runUntil(() -> !outcome.isEmpty(), Duration.ofMinutes(10));

    assertThat(outcome.get(0).reached()).as(String.join("\n", house.story)).isTrue();
    assertThat(house.coordinator.waits()).isEmpty();
    assertThat(house.story.stream().filter(told -> told.contains("Looks meanwhile")))
        .extracting(told -> told.replaceAll(".*(\\[0\\.\\d+]).*", "$1"))
        .doesNotHaveDuplicates()
        .hasSizeGreaterThan(16);
  }

  private static void foundIn(PretendHouse house, int room) {
    house.made.put("observeObject cam-" + room, step -> found(room));
  }

  private static ActionDispatcher.Report found(int room) {
    return PretendHouse.succeeded(
        Map.of(
            "found",
            new Term.Truth(true),
            "pose",
            new Term.Text("%d 1 0".formatted(3 * room + 1))));
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
    return lit(ROOMS);
  }

  private static PretendHouse lit(int rooms) {
    PretendHouse house = new PretendHouse(home(rooms));
    house.place.put("Cup", "nowhere");
    for (int room = 0; room < rooms; room++) {
      house.ambientLux.put("zone-" + room, 100.0);
      house.knowledge.state(
          new Source(Source.Kind.OBSERVED, "somebody"),
          List.of("(= (illuminance zone-%d) 100)".formatted(room)));
    }
    return house;
  }

  private static Home home(int rooms) {
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
    for (int room = 0; room < rooms; room++) {
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
