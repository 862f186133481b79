package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.rats.link.BusLink;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.MemberStatus;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.RatsError;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.PathPoint;

class SimulatedHomeTest {

  @Test
  void startsEveryDeviceInDeclaredOrder() {
    try (Homes homes = Homes.bob("bob-dark")) {
      assertThat(homes.simulated.devices())
          .containsExactly(
              "cam-a", "cam-b", "lamp-a1", "lamp-a2", "lamp-b1", "lamp-b2", "lamp-b3", "lux-a",
              "lux-b", "rose");
      assertThat(homes.link.members())
          .hasSize(10)
          .allMatch(member -> member.phase() == MemberStatus.Phase.READY);
    }
  }

  /**
   * Each asks in its own name, without anybody between them (Three-layered architecture, 2; M14).
   */
  @Test
  void aLampAsksARobotAndTheRobotALamp() {
    try (Homes homes = Homes.bob("bob-lit");
        RatsLink lamp =
            BusLink.connect("lamp-a1", "test", homes.bus.client("lamp-a1-asks"), homes.clock);
        RatsLink robot =
            BusLink.connect("rose", "test", homes.bus.client("rose-asks"), homes.clock)) {
      homes.clock.run(Duration.ofSeconds(1));
      Position before = homes.world().position("rose").orElseThrow();
      List<Result> ofRobot = new ArrayList<>();
      List<Result> ofLamp = new ArrayList<>();

      Map<String, Object> there = Map.of("to", Homes.ref("zone-a"));
      Duration limit = Duration.ofMinutes(1);
      lamp.call("rose", "move", there, limit, Optional.empty(), ofRobot::add);
      robot.call(
          "lamp-a1", "adjustLight", Map.of("level", 0.4), limit, Optional.empty(), ofLamp::add);
      homes.clock.run(limit);

      assertThat(ofRobot)
          .singleElement()
          .matches(result -> result.outcome() == Outcome.SUCCEEDED)
          .matches(result -> result.from().equals("rose"));
      assertThat(homes.world().position("rose")).isNotEqualTo(Optional.of(before));
      assertThat(ofLamp)
          .singleElement()
          .matches(result -> result.outcome() == Outcome.SUCCEEDED)
          .matches(result -> result.from().equals("lamp-a1"));
      assertThat(homes.world().lampLevel("lamp-a1")).isEqualTo(0.4);
    }
  }

  @Test
  void bringsBobHisCup() {
    try (Homes homes = Homes.bob("bob-dark")) {
      Duration bound = homes.simulated.lowerBound("rose", "Cup", "Bob");
      assertThat((double) homes.call("lux-b", "measureIllumination", Map.of()).values().get("lux"))
          .isBetween(16.0, 19.0);
      Result refused =
          homes
              .call("cam-b", "observeObject", Map.of("object", Homes.ref("Cup")))
              .result()
              .orElseThrow();
      assertThat(refused.outcome()).isEqualTo(Outcome.FAILED);
      RatsError error = refused.error().orElseThrow();
      assertThat(error.code()).isEqualTo(ErrorCode.PRECONDITION_NOT_MET);
      assertThat(error.refs()).hasSize(1);
      assertThat(error.refs().get(0).fact()).isEqualTo("(illuminance zone-b)");
      assertThat(error.refs().get(0).need()).isEqualTo(">= 72");
      assertThat((double) error.refs().get(0).have()).isBetween(16.0, 19.0);

      succeed(homes, "lamp-b1", "adjustLight", Map.of("level", 1));
      succeed(homes, "lamp-b2", "adjustLight", Map.of("level", 1));
      assertThat(homes.facts("lamp-b1")).containsExactly("(= (level lamp-b1) 1)");
      assertThat(homes.world().lux("zone-b")).isCloseTo(82, within(1.0));

      assertThat(homes.call("cam-b", "observeObject", Map.of("object", Homes.ref("Bob"))).values())
          .isEqualTo(Map.of("found", false));
      assertThat(
              position(homes, "cam-a", "Bob").distance(homes.world().position("Bob").orElseThrow()))
          .isLessThan(0.2);
      Position cup = position(homes, "cam-b", "Cup");
      assertThat(cup.distance(homes.world().position("Cup").orElseThrow())).isLessThan(0.15);

      Duration begun = homes.clock.now();
      succeed(homes, "rose", "pick", Map.of("object", homes.at("Cup")));
      assertThat(homes.facts("rose")).contains("(in Cup rose)", "(in rose zone-b)");
      assertThat(homes.world().isNextTo("Cup", "Bob")).isFalse();
      assertThat(homes.call("cam-b", "observeObject", Map.of("object", Homes.ref("Cup"))).values())
          .isEqualTo(Map.of("found", false));
      succeed(homes, "rose", "move", Map.of("to", Homes.ref("zone-a")));
      assertThat(homes.facts("rose")).contains("(in rose zone-a)");
      succeed(
          homes, "rose", "place", Map.of("object", Homes.ref("Cup"), "target", homes.at("Bob")));
      assertThat(homes.world().isNextTo("Cup", "Bob")).isTrue();
      assertThat(homes.facts("rose")).doesNotContain("(in Cup rose)");
      assertThat(position(homes, "cam-a", "Cup")).isNotNull();
      Duration taken = homes.clock.now().minus(begun);
      assertThat(taken).isBetween(bound, bound.multipliedBy(2));
      keepsClearOfWallsAndBob(homes);
    }
  }

  private static void keepsClearOfWallsAndBob(Homes homes) {
    List<PathPoint> path = homes.world().path("rose");
    assertThat(path).hasSizeGreaterThan(3);
    for (int i = 1; i < path.size(); i++) {
      assertThat(path.get(i).at()).isGreaterThanOrEqualTo(path.get(i - 1).at());
      Position point = Position.onFloor(path.get(i).point());
      assertThat(point.distance(homes.world().position("Bob").orElseThrow()))
          .isGreaterThan(0.25 + 0.346);
      assertThat(point.y()).isBetween(0.346, 3 - 0.346);
      if (Math.abs(point.x() - 3) < 0.3) {
        assertThat(point.y()).isBetween(1.9 + 0.1, 2.8 - 0.1);
      }
    }
  }

  private static Position position(Homes homes, String camera, String thing) {
    Map<String, Object> values =
        homes.call(camera, "observeObject", Map.of("object", Homes.ref(thing))).values();
    assertThat(values).containsEntry("found", true);
    List<?> pose = (List<?>) values.get("pose");
    return new Position(number(pose.get(0)), number(pose.get(1)), number(pose.get(2)));
  }

  private static double number(Object value) {
    return ((Number) value).doubleValue();
  }

  private static void succeed(
      Homes homes, String member, String feature, Map<String, Object> parameters) {
    Result result = homes.call(member, feature, parameters).result().orElseThrow();
    assertThat(result.outcome()).as(result.toString()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void refusesToExcludeUnderWeakLamps() {
    try (Homes homes = Homes.bob("bob-weak-lamps")) {
      succeed(homes, "lamp-b1", "adjustLight", Map.of("level", 1));
      succeed(homes, "lamp-b2", "adjustLight", Map.of("level", 1));
      RatsError error =
          homes
              .call("cam-b", "observeObject", Map.of("object", Homes.ref("Bob")))
              .result()
              .orElseThrow()
              .error()
              .orElseThrow();
      assertThat((double) error.refs().get(0).have()).isCloseTo(49.5, within(2.0));
      succeed(homes, "lamp-b3", "adjustLight", Map.of("level", 1));
      assertThat(homes.call("cam-b", "observeObject", Map.of("object", Homes.ref("Bob"))).values())
          .containsEntry("found", false);
    }
  }

  @Test
  void streamsWhereAThingIsUntilStopped() {
    try (Homes homes = Homes.bob("bob-lit")) {
      List<Map<String, Object>> seen = new ArrayList<>();
      List<Result> ended = new ArrayList<>();
      homes.link.call(
          "cam-b",
          "observeObject",
          Map.of("object", Homes.ref("Cup")),
          Duration.ofSeconds(10),
          Optional.empty(),
          new RatsLink.CallListener() {
            @Override
            public void observed(org.maestro.rats.protocol.Observation observation) {
              seen.add(observation.values());
            }

            @Override
            public void ended(Result result) {
              ended.add(result);
            }
          });
      homes.clock.run(Duration.ofSeconds(10));
      assertThat(seen).hasSizeBetween(17, 20).allMatch(values -> values.get("found").equals(true));
      homes.world().moveByHand("Cup", new Position(1, 1, 0));
      seen.clear();
      homes.clock.run(Duration.ofSeconds(2));
      assertThat(seen).last().isEqualTo(Map.of("found", false));
      succeed(homes, "cam-b", "stopObserve", Map.of("object", Homes.ref("Cup")));
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(ended).hasSize(1);
      seen.clear();
      homes.clock.run(Duration.ofSeconds(5));
      assertThat(seen).isEmpty();
    }
  }

  @Test
  void dropsWhatARobotHoldsThatDies() {
    try (Homes homes = Homes.bob("bob-lit")) {
      homes
          .world()
          .when(
              "rose",
              WorldEvent.Kind.PICKED,
              () ->
                  homes.clock.schedule(
                      Duration.ofSeconds(1), "test", () -> homes.world().die("rose")));
      Result lost =
          homes.call("rose", "pick", Map.of("object", homes.at("Cup"))).result().orElseThrow();
      assertThat(lost.outcome()).isNotEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.world().holder("Cup")).isEmpty();
      assertThat(homes.world().distance("Cup", "rose")).isLessThan(0.5);
      assertThat(phase(homes, "rose")).isEqualTo(MemberStatus.Phase.LOST);
      homes.world().revive("rose");
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(phase(homes, "rose")).isEqualTo(MemberStatus.Phase.READY);
      succeed(homes, "rose", "pick", Map.of("object", homes.at("Cup")));
    }
  }

  @Test
  void losesALampWhenItIsSwitched() {
    try (Homes homes =
        new Homes(
            "bob",
            "bob-dark",
            1,
            scene -> scene.with("lamp-b2", dyingUpon(WorldEvent.Kind.ADJUST)))) {
      Result lost = homes.call("lamp-b2", "adjustLight", Map.of("level", 1)).result().orElseThrow();
      assertThat(lost.outcome()).isNotEqualTo(Outcome.SUCCEEDED);
      assertThat(phase(homes, "lamp-b2")).isEqualTo(MemberStatus.Phase.LOST);
      assertThat(homes.world().lux("zone-b")).isCloseTo(17, within(0.01));
    }
  }

  private static Scene.Entry dyingUpon(WorldEvent.Kind kind) {
    Scene.Entry none = Scene.Entry.NOTHING;
    return new Scene.Entry(
        none.position(),
        none.hidden(),
        none.radius(),
        none.mass(),
        none.level(),
        none.strength(),
        none.ambientLux(),
        none.open(),
        none.dead(),
        none.speed(),
        none.payload(),
        Optional.of(kind),
        none.colour(),
        none.charge(),
        none.charges(),
        none.celsius());
  }

  private static MemberStatus.Phase phase(Homes homes, String id) {
    return homes.link.members().stream()
        .filter(member -> member.id().equals(id))
        .findFirst()
        .orElseThrow()
        .phase();
  }

  @Test
  void putsDownWhatItHoldsOnCancel() {
    try (Homes homes = Homes.bob("bob-lit")) {
      succeed(homes, "rose", "pick", Map.of("object", homes.at("Cup")));
      List<Result> results = new ArrayList<>();
      RatsLink.CallHandle handle =
          homes.link.call(
              "rose",
              "place",
              Map.of("object", Homes.ref("Cup"), "target", homes.at("Bob")),
              Duration.ofSeconds(60),
              Optional.empty(),
              results::add);
      homes.clock.run(Duration.ofSeconds(1));
      handle.cancel();
      homes.clock.run(Duration.ofSeconds(5));
      assertThat(results).hasSize(1);
      assertThat(results.get(0).outcome()).isEqualTo(Outcome.CANCELED);
      assertThat(results.get(0).state()).isEqualTo("safe");
      assertThat(homes.world().holder("Cup")).isEmpty();
      assertThat(homes.world().distance("Cup", "rose")).isLessThan(0.55);
    }
  }

  @Test
  void isTheSameWithTheSameSeed() {
    assertThat(measured(7)).isEqualTo(measured(7)).isNotEqualTo(measured(8));
  }

  private static String measured(long seed) {
    try (Homes homes = new Homes("bob", "bob-lit", seed, scene -> scene)) {
      return homes.call("lux-b", "measureIllumination", Map.of()).values()
          + " "
          + position(homes, "cam-b", "Cup");
    }
  }

  @Test
  void pricesFromWhereTheRobotIs() {
    try (Homes homes = Homes.bob("bob-lit")) {
      List<Double> prices = new ArrayList<>();
      homes.link.cost(
          "rose",
          "move",
          List.of(Map.of("to", Homes.ref("zone-a")), Map.of("to", Homes.ref("zone-b"))),
          answers -> answers.forEach(answer -> prices.add(answer.cost().orElseThrow())));
      homes.link.cost(
          "rose",
          "pick",
          List.of(Map.of("object", homes.at("Cup")), Map.of("object", Homes.ref("Cup"))),
          answers -> answers.forEach(answer -> prices.add(answer.cost().orElseThrow())));
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(prices).hasSize(4);
      assertThat(prices.get(0)).isBetween(2.0, 5.0);
      assertThat(prices.get(1)).isBetween(0.5, 0.6);
      assertThat(prices.get(2)).isBetween(4.0, 8.0);
      assertThat(prices.get(3)).isBetween(4.0, 4.5);
    }
  }

  /** Otherwise a way of several rooms would count its first leg once for each. */
  @Test
  void pricesALegFromWhereItBegins() {
    try (Homes homes = Homes.bob("bob-lit")) {
      List<Double> prices = new ArrayList<>();
      homes.link.cost(
          "rose",
          "move",
          List.of(
              Map.of("to", Homes.ref("zone-a"), "from", Homes.ref("zone-b")),
              Map.of("to", Homes.ref("zone-b"), "from", Homes.ref("zone-a")),
              Map.of("to", Homes.ref("zone-b"))),
          answers -> answers.forEach(answer -> prices.add(answer.cost().orElseThrow())));
      homes.clock.run(Duration.ofSeconds(1));
      assertThat(prices).hasSize(3);
      assertThat(prices.get(1))
          .as("back through the door, for who is in zone-b now")
          .isGreaterThan(prices.get(2) + 0.1)
          .isLessThan(prices.get(0));
    }
  }
}
