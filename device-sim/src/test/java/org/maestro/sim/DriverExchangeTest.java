package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;

/**
 * The same members with other drivers, chosen by the home file alone (Three-layered architecture,
 * 3.1; M26).
 */
class DriverExchangeTest {

  private static Homes bob(String scene, String instead, String by) {
    return bob(scene, instead, by, 0);
  }

  private static Homes bob(String scene, String instead, String by, double slip) {
    Home home = new HomeLoader().load(Homes.text("bob").replace(instead, by), "bob.ttl");
    return new Homes(
        home,
        Homes.scene(scene, home),
        1,
        usual -> usual.with(Map.of("world.wheels.slip", String.valueOf(slip))));
  }

  private static Homes withRoseOn(String driver) {
    return withRoseOn(driver, 0.02);
  }

  private static Homes withRoseOn(String driver, double slip) {
    return bob(
        "bob-lit",
        "home:rose a :MobileRobot ;",
        "home:rose a :MobileRobot ; maestro:driver \"" + driver + "\" ;",
        slip);
  }

  private static void succeed(
      Homes homes, String member, String feature, Map<String, Object> with) {
    Result result = homes.call(member, feature, with).result().orElseThrow();
    assertThat(result.outcome())
        .describedAs("%s: %s", feature, result)
        .isEqualTo(Outcome.SUCCEEDED);
  }

  @ParameterizedTest
  @ValueSource(strings = {"mobile-robot", "mecanum-robot", "differential-robot"})
  void bringsTheCupOnAnyWheels(String driver) {
    try (Homes homes = withRoseOn(driver)) {
      succeed(homes, "rose", "pick", Map.of("object", homes.at("Cup")));
      succeed(
          homes, "rose", "move", Map.of("to", Homes.ref("zone-a"), "from", Homes.ref("zone-b")));
      succeed(
          homes, "rose", "place", Map.of("object", Homes.ref("Cup"), "target", homes.at("Bob")));
      assertThat(homes.world().isNextTo("Cup", "Bob")).isTrue();
    }
  }

  @Test
  void evensOutTheSlipOfItsWheels() {
    double straight = seconds("mobile-robot", 0);
    assertThat(seconds("mecanum-robot", 0.02)).isBetween(0.98 * straight, 1.1 * straight);
    assertThat(seconds("differential-robot", 0.02)).isBetween(straight + 0.5, straight + 10);
  }

  /** Of a way it loses 0.8 times the standard deviation in the mean: 16 % of the time at 20 %. */
  @Test
  void aBaseWithoutWheelsOfItsOwnSlipsToo() {
    double straight = seconds("mobile-robot", 0);
    assertThat(seconds("mobile-robot", 0.2)).isBetween(1.08 * straight, 1.3 * straight);
  }

  private static double seconds(String driver, double slip) {
    try (Homes homes = withRoseOn(driver, slip)) {
      Duration begun = homes.clock.now();
      succeed(
          homes, "rose", "move", Map.of("to", Homes.ref("zone-a"), "from", Homes.ref("zone-b")));
      return homes.clock.now().minus(begun).toMillis() / 1e3;
    }
  }

  @Test
  void standsStillWhenItsPowerIsGone() {
    try (Homes homes = withRoseOn("mecanum-robot")) {
      homes.link.call(
          "rose",
          "move",
          Map.of("to", Homes.ref("zone-a")),
          Duration.ofSeconds(30),
          Optional.empty(),
          result -> {});
      homes.clock.run(Duration.ofSeconds(1));
      homes.world().die("rose");
      var place = homes.world().position("rose");
      homes.clock.run(Duration.ofSeconds(5));
      assertThat(homes.world().position("rose")).isEqualTo(place);
    }
  }

  @Test
  void saysWhatIsWrongWithItsMotors() {
    try (Homes homes = withRoseOn("mecanum-robot")) {
      homes.world().breakDown("rose", "a motor is hot");
      Result result =
          homes.call("rose", "move", Map.of("to", Homes.ref("zone-a"))).result().orElseThrow();
      assertThat(result.outcome()).isEqualTo(Outcome.FAILED);
      assertThat(result.error().orElseThrow().message()).contains("a motor is hot");
    }
  }

  @Test
  void aLampBehindASwitchIsOnOrOff() {
    try (Homes homes =
        bob("bob-dark", "home:lamp-b1 a :Lamp ;", "home:lamp-b1 a :SwitchedLamp ;")) {
      succeed(homes, "lamp-b1", "adjustLight", Map.of("level", 1));
      assertThat(homes.world().lampLevel("lamp-b1")).isEqualTo(1);
      Result half =
          homes.call("lamp-b1", "adjustLight", Map.of("level", 0.5)).result().orElseThrow();
      assertThat(half.outcome()).isEqualTo(Outcome.FAILED);
      assertThat(homes.world().lampLevel("lamp-b1")).isEqualTo(1);
    }
  }

  @Test
  void aTunableLampHasFourWhites() {
    try (Homes homes = bob("bob-dark", "home:lamp-b1 a :Lamp ;", "home:lamp-b1 a :TunableLamp ;")) {
      succeed(homes, "lamp-b1", "adjustLight", Map.of("level", 1, "white", 4000));
      Result blue =
          homes
              .call("lamp-b1", "adjustLight", Map.of("level", 1, "white", 9000))
              .result()
              .orElseThrow();
      assertThat(blue.outcome()).isEqualTo(Outcome.FAILED);
    }
  }

  @Test
  void aCountingSensorMeasuresFromADarkRoomToSunlight() {
    try (Homes homes =
        bob(
            "bob-dark",
            "home:lux-b a :LightSensor ;",
            "home:lux-b a :LightSensor ; maestro:driver \"tsl2561\" ;")) {
      for (double lux : new double[] {0.05, 17, 300, 2_500, 12_000, 35_000, 90_000}) {
        homes.world().setAmbient("zone-b", lux);
        List<Double> readings = new ArrayList<>();
        for (int i = 0; i < 3; i++) {
          var answer = homes.call("lux-b", "measureIllumination", Map.of());
          readings.add((Double) answer.values().get("lux"));
          answer.handle().orElseThrow().cancel();
          homes.clock.run(Duration.ofSeconds(1));
        }
        double expected = Math.max(0.1, Math.min(40_000, lux));
        assertThat(readings)
            .allSatisfy(
                reading -> assertThat(reading).isCloseTo(expected, within(0.04 * expected)));
      }
    }
  }
}
