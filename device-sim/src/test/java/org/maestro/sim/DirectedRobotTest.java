package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.device.tasks.DeviceSetupException;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Progress;
import org.maestro.rats.protocol.Result;

/** A wheeled robot that is told by turns and distances where to go; never into anything. */
class DirectedRobotTest {
  private static final String ROVER = "rover";

  /** Of the circle around the robot, less what a planned way may graze. */
  private static final double LEAST_METRES = 0.347 - 0.011;

  private Homes homes = exploration("exploring-robot");

  /** With a robot of no words but those of all wheeled robots. */
  private static Homes exploration(String driver) {
    String text = Homes.text("exploration");
    Home home =
        new HomeLoader()
            .load(
                text.substring(0, text.indexOf("# --- What is done when somebody says so"))
                    .replace(
                        "home:rover a home:Rover ;",
                        "home:rover a :WheeledRobot ; maestro:driver \"" + driver + "\" ;"),
                "exploration.ttl");
    return new Homes(home, Homes.scene("exploration", home), 1);
  }

  @AfterEach
  void close() {
    homes.close();
  }

  private Result call(String feature, Map<String, Object> parameters) {
    return homes.call(ROVER, feature, parameters).result().orElseThrow();
  }

  private Point2 place() {
    return homes.world().position(ROVER).orElseThrow().floor();
  }

  @ParameterizedTest
  @ValueSource(strings = {"differential-robot", "mecanum-robot"})
  void itTurnsAndGoesAsFarAsItIsTold(String driver) {
    close();
    homes = exploration(driver);
    assertThat(call("turn", Map.of("degrees", 90)).values()).containsEntry("heading", 90.0);
    Result driven = call("drive", Map.of("metres", 2));
    assertThat(driven.values()).containsEntry("driven", 2.0).containsEntry("blocked", false);
    assertThat(place().distance(new Point2(3, 5))).isLessThan(0.02);

    assertThat(call("turn", Map.of("degrees", -450)).values()).containsEntry("heading", 0.0);
    call("drive", Map.of("metres", 1.5));
    assertThat(place().distance(new Point2(4.5, 5))).isLessThan(0.04);
    assertThat(homes.facts(ROVER)).contains("(= (heading rover) 0)", "(in rover plain)");
  }

  @Test
  void aTurnTakesTheTimeOfItsWheels() {
    Duration begun = homes.clock.now();
    call("turn", Map.of("degrees", -180));
    assertThat(homes.clock.now().minus(begun).toMillis() / 1e3).isCloseTo(2, within(0.05));
    assertThat(place()).isEqualTo(new Point2(3, 3));
  }

  @ParameterizedTest
  @ValueSource(strings = {"differential-robot", "mecanum-robot"})
  void itGoesToAPositionAndLooksWhereItIsTold(String driver) {
    close();
    homes = exploration(driver);
    Result there = call("goTo", Map.of("x", 5, "y", 4, "heading", 270));

    assertThat(there.values())
        .containsEntry("reachedX", 5.0)
        .containsEntry("reachedY", 4.0)
        .containsEntry("facing", 270.0);
    assertThat(place().distance(new Point2(5, 4))).isLessThan(0.05);
    assertThat(homes.facts(ROVER)).contains("(= (heading rover) 270)");
  }

  @Test
  void whereNoPlaceIsItDoesNotGo() {
    Result refused = call("goTo", Map.of("x", 500, "y", 4));

    assertThat(refused.error().orElseThrow().message())
        .isEqualTo("The position (500, 4) is in none of the places that are on the map.");
    assertThat(place()).isEqualTo(new Point2(3, 3));
  }

  @Test
  void beforeWhatIsInItsWayItStandsStillAndSaysSo() {
    Result without = call("drive", Map.of());
    assertThat(without.outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(without.values()).containsEntry("blocked", true);
    assertThat(place().x()).isBetween(20 - 0.347 - 0.1, 20 - LEAST_METRES);

    Result with = call("drive", Map.of("metres", 3));
    assertThat(with.outcome()).isEqualTo(Outcome.FAILED);
    assertThat(with.error().orElseThrow().message())
        .isEqualTo("Something stands in the way after 0 m.");
    assertThat(with.error().orElseThrow().refs().get(0).fact()).isEqualTo("(blocked rover)");
  }

  @Test
  void itGoesOnUntilItIsToldToStandStill() {
    List<Result> ended = begin("drive", Map.of());
    homes.clock.run(Duration.ofSeconds(5));
    assertThat(ended).isEmpty();

    assertThat(call("halt", Map.of()).outcome()).isEqualTo(Outcome.SUCCEEDED);
    assertThat(ended.get(0).outcome()).isEqualTo(Outcome.SUCCEEDED);
    Point2 there = place();
    assertThat(there.x()).isCloseTo(3 + 5 * 0.7, within(0.1));
    assertThat(ended.get(0).values()).containsEntry("blocked", false);
    homes.clock.run(Duration.ofSeconds(5));
    assertThat(place()).isEqualTo(there);
    assertThat(call("halt", Map.of()).outcome()).isEqualTo(Outcome.SUCCEEDED);
  }

  @Test
  void whoHasSaidHowFarIsToldThatItStoodStillBefore() {
    List<Result> driving = begin("drive", Map.of("metres", 5));
    homes.clock.run(Duration.ofSeconds(2));
    call("halt", Map.of());
    assertThat(driving.get(0).error().orElseThrow().message())
        .matches("It was told to stand still after 1\\.[345] m\\.");

    List<Result> turning = begin("turn", Map.of("degrees", 180));
    homes.clock.run(Duration.ofSeconds(1));
    call("halt", Map.of());
    assertThat(turning.get(0).error().orElseThrow().message())
        .contains("told to stand still while it turned");
  }

  /** What chance has it do: the floor around its body stays free. */
  @ParameterizedTest
  @ValueSource(longs = {1, 2, 3, 4})
  void whateverItIsToldItTouchesNothing(long seed) {
    Random random = new Random(seed);
    List<Segment> walls = homes.world().building().walls();
    for (int i = 0; i < 60; i++) {
      if (random.nextBoolean()) {
        call("turn", Map.of("degrees", random.nextInt(360) - 180));
      } else {
        begin("drive", random.nextBoolean() ? Map.of() : Map.of("metres", 1 + random.nextInt(9)));
        for (int tenth = random.nextInt(120); tenth > 0; tenth--) {
          homes.clock.run(Duration.ofMillis(100));
          assertThat(free(walls)).as("after %d at %s", i, place()).isGreaterThan(LEAST_METRES);
        }
        call("halt", Map.of());
      }
    }
  }

  /** Metres from its middle to what is nearest. */
  private double free(List<Segment> walls) {
    double free = Double.POSITIVE_INFINITY;
    for (Segment wall : walls) {
      free = Math.min(free, wall.distance(place()));
    }
    for (Obstacle body : homes.world().whereabouts().obstacles(ROVER)) {
      free = Math.min(free, body.middle().distance(place()) - body.radius());
    }
    return free;
  }

  @Test
  void whatMakesNoSenseIsNamed() {
    for (Object metres : List.of(0, -1, 2000)) {
      assertThat(call("drive", Map.of("metres", metres)).error().orElseThrow().message())
          .contains("more than 0 and 1000 at most");
    }
    assertThat(call("turn", Map.of("degrees", "left")).error().orElseThrow().message())
        .contains("degrees is a number, not left");
  }

  @Test
  void aBaseWithoutAFrontIsNotToldByTurns() {
    assertThatThrownBy(() -> exploration("mobile-robot"))
        .isInstanceOf(DeviceSetupException.class)
        .hasMessageContaining("but its driver is no Steering");
  }

  private List<Result> begin(String feature, Map<String, Object> parameters) {
    List<Result> ended = new ArrayList<>();
    homes.link.call(
        ROVER,
        feature,
        parameters,
        Duration.ofMinutes(10),
        Optional.empty(),
        new RatsLink.CallListener() {
          @Override
          public void progressed(Progress progress) {}

          @Override
          public void observed(Observation observation) {}

          @Override
          public void ended(Result result) {
            ended.add(result);
          }
        });
    return ended;
  }
}
