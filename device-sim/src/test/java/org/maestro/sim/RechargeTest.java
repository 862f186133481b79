package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.scene.Scene;

/** Batteries are filled at stations: 120 Wh at 192 W, less the 20 W that the robot draws idle. */
class RechargeTest {

  private static final Map<String, Object> TO_THE_DOCK =
      Map.of(
          "station",
          Map.of("ref", "https://w3id.org/maestro/home/flat#dock", "referencePoint", "0.45 2.5 0"));
  private static final double SECONDS_OF_A_HUNDREDTH = 0.01 * 120 * 3600 / (192 - 20);

  private static Homes flat(boolean charges) {
    Home home = Homes.home("flat");
    Scene scene = Homes.scene("flat-day", home);
    return new Homes(home, charges ? scene : scene.with("dock", Scene.Entry.NOTHING), 1);
  }

  @Test
  void drivesToTheStationAndStandsThereUntilItIsFull() {
    try (Homes homes = flat(true)) {
      homes.world().charge("rose", 0.99);
      Duration begun = homes.clock.now();
      Result result = homes.call("rose", "recharge", TO_THE_DOCK).result().orElseThrow();
      assertThat(result.outcome()).isEqualTo(Outcome.SUCCEEDED);
      double seconds = homes.clock.now().minus(begun).toMillis() / 1e3;
      double driving = Math.hypot(0.8 - 0.45, 1.0 - 2.5) / 0.8;
      double drivingDraws = driving * (80 + 20) / (192 - 20);
      assertThat(seconds).isCloseTo(driving + SECONDS_OF_A_HUNDREDTH + drivingDraws, within(0.3));
      assertThat(homes.world().charge("rose")).isCloseTo(1, within(1e-4));
      assertThat(homes.facts("rose")).contains("(= (charge rose) 1)");
    }
  }

  @Test
  void isNotChargedElsewhere() {
    try (Homes homes = flat(false)) {
      Result result = homes.call("rose", "recharge", TO_THE_DOCK).result().orElseThrow();
      assertThat(result.outcome()).isEqualTo(Outcome.FAILED);
      assertThat(result.error().orElseThrow().message()).contains("no charging station here");
    }
  }

  @Test
  void isChargedNoFurtherOnceCancelled() {
    try (Homes homes = flat(true)) {
      homes.world().charge("rose", 0.5);
      RatsLink.CallHandle call =
          homes.link.call(
              "rose", "recharge", TO_THE_DOCK, Duration.ofHours(1), Optional.empty(), result -> {});
      homes.clock.run(Duration.ofSeconds(60));
      assertThat(homes.world().charge("rose")).isGreaterThan(0.51);
      call.cancel();
      homes.clock.run(Duration.ofSeconds(1));
      double then = homes.world().charge("rose");
      homes.clock.run(Duration.ofSeconds(60));
      assertThat(homes.world().charge("rose")).isLessThan(then);
      Position dock = new Position(0.45, 2.5, 0);
      assertThat(homes.world().position("rose").orElseThrow().distance(dock)).isLessThan(0.05);
    }
  }
}
