package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.parameters.ArmData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.PathPoint;

class RobotTest {

  private final Homes homes = Homes.bob("bob-lit");

  @AfterEach
  void close() {
    homes.close();
  }

  private Result call(String feature, Map<String, Object> parameters) {
    return homes.call("rose", feature, parameters).result().orElseThrow();
  }

  private Result moveToA() {
    return call("move", Map.of("to", Homes.ref("zone-a"), "from", Homes.ref("zone-b")));
  }

  @Test
  void drivesAtTheSpeedOfItsDataSheet() {
    Duration begun = homes.clock.now();
    assertThat(moveToA().outcome()).isEqualTo(Outcome.SUCCEEDED);
    List<PathPoint> path = homes.world().path("rose");
    double length = 0;
    for (int i = 1; i < path.size(); i++) {
      length += path.get(i).point().distance(path.get(i - 1).point());
    }
    double seconds = homes.clock.now().minus(begun).toNanos() / 1e9;
    assertThat(seconds).isBetween(length / 0.8, length / 0.8 + 0.05);
    assertThat(homes.world().zone("rose")).contains("zone-a");
  }

  @Test
  void ofALongDayTheLatestOfItsWayIsKept() {
    for (int round = 0; round < 1_200; round++) {
      String to = round % 2 == 0 ? "zone-a" : "zone-b";
      call("move", Map.of("to", Homes.ref(to)));
    }
    List<PathPoint> path = homes.world().path("rose");
    assertThat(path).hasSizeBetween(1_000, 2_100);
    assertThat(path.get(path.size() - 1).point())
        .isEqualTo(homes.world().position("rose").orElseThrow().floor());
  }

  @Test
  void isWhereItHasComeToWhileItDrives() {
    homes.link.call(
        "rose",
        "move",
        Map.of("to", Homes.ref("zone-a")),
        Duration.ofSeconds(30),
        Optional.empty(),
        result -> {});
    Position start = homes.world().position("rose").orElseThrow();
    homes.clock.run(Duration.ofMillis(1000));
    assertThat(homes.world().position("rose").orElseThrow().distance(start)).isBetween(0.7, 0.8);
  }

  @Test
  void stopsStraightOnItsWayToWhatItDoesNext() {
    try (Homes arena = new Homes("arena", "arena-light", 1, scene -> scene)) {
      Point2 start = floor(arena, "rose");
      Point2 next = new Point2(1.2, 2.6);
      assertThat(
              arena
                  .call(
                      "rose",
                      "move",
                      Map.of("to", Homes.ref("zone-1"), "onward", List.of(next.x(), next.y(), 0.0)))
                  .result()
                  .orElseThrow()
                  .outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      Point2 end = floor(arena, "rose");
      assertThat(start.distance(end) + end.distance(next))
          .as("no detour")
          .isLessThan(start.distance(next) + 0.005);
      // As far as to where the whole base stands in zone 1, which ends at 2.8 m, and no farther.
      assertThat(end.x()).isBetween(2.8 - 0.347 - 0.011, 2.8 - 0.347);
    }
  }

  @Test
  void standsNoNearerToWhatItPicksThanItsArmReaches() {
    try (Homes arena = new Homes("arena", "arena-light", 1, scene -> scene)) {
      arena.world().moveByHand("GreenObject", new Position(1.0, 2.3, 0));
      double before = floor(arena, "rose").distance(floor(arena, "GreenObject"));
      Point2 start = floor(arena, "rose");
      assertThat(
              arena
                  .call("rose", "pick", Map.of("object", arena.at("GreenObject")))
                  .result()
                  .orElseThrow()
                  .outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(start.distance(floor(arena, "rose")))
          .isCloseTo(before - ArmData.YOUBOT.reach(), within(1e-3));
    }
  }

  private static Point2 floor(Homes homes, String name) {
    return homes.world().position(name).orElseThrow().floor();
  }

  @Test
  void saysThatAClosedDoorBarsTheWay() {
    homes.world().setDoor("door-ab", false);
    Result result = moveToA();
    assertThat(result.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(result.error().orElseThrow().code()).isEqualTo(ErrorCode.PRECONDITION_NOT_MET);
    assertThat(result.error().orElseThrow().refs().get(0).fact())
        .isEqualTo("(passable zone-b zone-a)");
  }

  @Test
  void namesWhatStandsInTheOnlyWay() {
    homes.world().moveByHand("Bob", new Position(3, 2.35, 0));
    homes.world().moveByHand("Cup", new Position(3.6, 2.35, 0));
    assertThat(moveToA().error().orElseThrow().message())
        .isEqualTo("Cannot drive to zone-a: there is no free way: Bob stands in it.");
    List<String> reasons = new ArrayList<>();
    homes.link.cost(
        "rose",
        "move",
        List.of(Map.of("to", Homes.ref("zone-a"))),
        answers -> answers.forEach(answer -> reasons.add(answer.reason().orElseThrow())));
    homes.clock.run(Duration.ofSeconds(1));
    assertThat(reasons).containsExactly("There is no free way to zone-a: Bob stands in it");
    homes.world().moveByHand("Cup", new Position(2.5, 2.35, 0));
    assertThat(call("pick", Map.of("object", homes.at("Cup"))).error().orElseThrow().message())
        .isEqualTo("Cannot drive to Cup: there is no free way: Bob stands in it.");
  }

  @Test
  void namesBothOfWhichEitherWouldLeaveNoWay() {
    homes.world().moveByHand("Bob", new Position(3, 1.9, 0));
    homes.world().moveByHand("Cup", new Position(3, 2.6, 0));
    assertThat(moveToA().error().orElseThrow().message())
        .isEqualTo("Cannot drive to zone-a: there is no free way: Bob and Cup stand in it.");
  }

  @Test
  void namesNobodyWhereADoorBarsTheWay() {
    homes.world().setDoor("door-ab", false);
    homes.world().moveByHand("Bob", new Position(3.5, 2.35, 0));
    assertThat(moveToA().error().orElseThrow().message())
        .isEqualTo("Cannot drive to zone-a: there is no free way.");
  }

  @Test
  void standsStillBeforeADoorThatCloses() {
    homes
        .world()
        .when(
            "rose",
            WorldEvent.Kind.DRIVE,
            () ->
                homes.clock.schedule(
                    Duration.ofMillis(500), "test", () -> homes.world().setDoor("door-ab", false)));
    assertThat(moveToA().outcome()).isEqualTo(Outcome.FAILED);
    assertThat(homes.world().zone("rose")).contains("zone-b");
  }

  @Test
  void drivesAroundAPersonThatStepsInItsWay() {
    List<WorldEvent.Kind> events = new ArrayList<>();
    homes.world().listen(event -> events.add(event.kind()));
    homes
        .world()
        .when(
            "rose",
            WorldEvent.Kind.DRIVE,
            () ->
                homes.clock.schedule(
                    Duration.ofMillis(600),
                    "test",
                    () -> homes.world().moveByHand("Bob", new Position(3.75, 1.7, 0))));
    Result result = call("pick", Map.of("object", atAfterMove("Cup", new Position(3.6, 2.6, 0))));
    assertThat(events).contains(WorldEvent.Kind.BLOCKED);
    assertThat(result.outcome()).as(result.toString()).isEqualTo(Outcome.SUCCEEDED);
  }

  private Map<String, Object> atAfterMove(String thing, Position place) {
    homes.world().moveByHand(thing, place);
    return homes.at(thing);
  }

  @Test
  void saysThatItsHandIsEmptyWhenSomebodyTakesTheThingOutOfIt() {
    assertThat(call("pick", Map.of("object", homes.at("Cup"))).outcome())
        .isEqualTo(Outcome.SUCCEEDED);
    assertThat(homes.facts("rose")).contains("(in Cup rose)");
    homes.world().moveByHand("Cup", new Position(3.6, 2.6, 0));
    homes.clock.run(Duration.ofSeconds(1));
    assertThat(homes.facts("rose")).doesNotContain("(in Cup rose)");
  }

  @Test
  void doesNotGraspWhatIsNotThereOrTooHeavy() {
    Map<String, Object> there = homes.at("Cup");
    homes.world().moveByHand("Cup", new Position(5.5, 0.5, 0));
    Result missed = call("pick", Map.of("object", there));
    assertThat(missed.error().orElseThrow().message()).contains("not where it was seen");
    homes
        .world()
        .whereabouts()
        .put(new Body("Cup", new Position(5.5, 0.5, 0), 0.04, 3, false, Optional.empty()));
    Result heavy = call("pick", Map.of("object", homes.at("Cup")));
    assertThat(heavy.error().orElseThrow().message()).contains("heavier than 0.5 kg");
  }

  @Test
  void placesWithinAnArea() {
    assertThat(call("pick", Map.of("object", homes.at("Cup"))).outcome())
        .isEqualTo(Outcome.SUCCEEDED);
    assertThat(
            call("place", Map.of("object", Homes.ref("Cup"), "target", Homes.ref("zone-b")))
                .outcome())
        .isEqualTo(Outcome.SUCCEEDED);
    assertThat(homes.world().zone("Cup")).contains("zone-b");
    assertThat(homes.world().holder("Cup")).isEmpty();
  }

  @Test
  void remembersWhereItPutWhatItsCallerKnowsOnlyByItsRoom() {
    call("pick", Map.of("object", homes.at("Cup")));
    call("place", Map.of("object", Homes.ref("Cup"), "target", Homes.ref("zone-b")));
    assertThat(call("pick", Map.of("object", Homes.ref("Cup"))).outcome())
        .isEqualTo(Outcome.SUCCEEDED);
    assertThat(homes.world().holder("Cup")).contains("rose");
  }

  @Test
  void refusesToPlaceWhatItDoesNotHoldAndToPickTwice() {
    Result placed = call("place", Map.of("object", Homes.ref("Cup"), "target", homes.at("Bob")));
    assertThat(placed.error().orElseThrow().refs().get(0).fact()).isEqualTo("(in Cup rose)");
    call("pick", Map.of("object", homes.at("Cup")));
    Result picked = call("pick", Map.of("object", homes.at("Cup")));
    assertThat(picked.error().orElseThrow().refs().get(0).fact()).isEqualTo("(handFree rose)");
  }

  /** Three-layered architecture, 3.2.1 (M33). */
  @Test
  void tellsWhatItsHandDoesNotAllowAsDisabled() {
    assertThat(disabled()).as("with an empty hand").containsExactly("place");

    call("pick", Map.of("object", homes.at("Cup")));
    homes.clock.run(Duration.ofSeconds(1));
    assertThat(disabled()).as("while it carries").containsExactly("pick");
    assertThat(call("pick", Map.of("object", homes.at("Bob"))).error().orElseThrow().message())
        .isEqualTo("The hand holds Cup already.");

    call("place", Map.of("object", Homes.ref("Cup"), "target", Homes.ref("zone-b")));
    homes.clock.run(Duration.ofSeconds(1));
    assertThat(disabled()).as("with an empty hand again").containsExactly("place");
  }

  private List<String> disabled() {
    return homes.link.members().stream()
        .filter(member -> member.id().equals("rose"))
        .flatMap(member -> member.state().stream())
        .findFirst()
        .orElseThrow()
        .disabled();
  }

  /** A call counts on what those before it in the queue bring about. */
  @Test
  void placesWhatItWasStillAtPickingUpWhenItWasTold() {
    List<Outcome> outcomes = new ArrayList<>();
    call(outcomes, "pick", Map.of("object", homes.at("Cup")));
    call(outcomes, "place", Map.of("object", Homes.ref("Cup"), "target", Homes.ref("zone-b")));

    homes.clock.runUntil(() -> outcomes.size() == 2, Duration.ofSeconds(90));

    assertThat(outcomes).containsExactly(Outcome.SUCCEEDED, Outcome.SUCCEEDED);
  }

  private void call(List<Outcome> outcomes, String feature, Map<String, Object> parameters) {
    homes.link.call(
        "rose",
        feature,
        parameters,
        Duration.ofSeconds(60),
        Optional.empty(),
        result -> outcomes.add(result.outcome()));
  }

  @Test
  void answersFaultyParametersWithoutBreaking() {
    assertThat(call("pick", Map.of("object", 3)).error().orElseThrow().code())
        .isEqualTo(ErrorCode.INVALID_PARAMETERS);
    assertThat(call("pick", Map.of("object", Homes.ref("Cup"))).error().orElseThrow().message())
        .contains("without position");
    assertThat(call("move", Map.of("to", Homes.ref("attic"))).error().orElseThrow().message())
        .contains("attic is not on the map");
  }

  @Test
  void failsWhileItIsBroken() {
    homes.world().breakDown("rose", "The wheels are stuck.");
    assertThat(moveToA().outcome()).isEqualTo(Outcome.FAILED);
    homes.world().repair("rose");
    assertThat(moveToA().outcome()).isEqualTo(Outcome.SUCCEEDED);
  }
}
