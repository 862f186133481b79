package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.hal.MobileBase;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** A robot whose wheels slip errs about where it is, until it looks. */
class OdometryTest {
  private static final int ROUNDS = 60;

  private static Homes roseOnWheels(double slip, double matchShare) {
    Home home =
        new HomeLoader()
            .load(
                Homes.text("bob")
                    .replace(
                        "home:rose a :MobileRobot ;",
                        "home:rose a :MobileRobot ; maestro:driver \"mecanum-robot\" ;"),
                "bob.ttl");
    return new Homes(
        home,
        Homes.scene("bob-lit", home),
        1,
        usual ->
            usual.with(
                Map.of(
                    "world.wheels.slip", String.valueOf(slip),
                    "world.scanner.matchShare", String.valueOf(matchShare))));
  }

  /** How far from where it believes to be, at most, as often as a drive has ended; metres. */
  private static double greatestError(double slip, double matchShare) {
    try (Homes homes = roseOnWheels(slip, matchShare)) {
      MobileBase base = homes.simulated.drivers("rose").find(MobileBase.class).orElseThrow();
      double greatest = 0;
      for (int round = 0; round < ROUNDS; round++) {
        homes.call("rose", "move", Map.of("to", Homes.ref(round % 2 == 0 ? "zone-a" : "zone-b")));
        greatest =
            Math.max(
                greatest,
                base.position().distance(homes.world().position("rose").orElseThrow().floor()));
      }
      return greatest;
    }
  }

  @Test
  void wheelsThatDoNotSlipAreReckonedByExactly() {
    assertThat(greatestError(0, 0)).isZero();
    assertThat(greatestError(0, 0.2)).isZero();
  }

  @Test
  void slipLeadsAstrayAsLongAsNothingIsMatched() {
    assertThat(greatestError(0.3, 0)).isGreaterThan(0.15);
  }

  @Test
  void whatIsSeenKeepsTheErrorSmall() {
    assertThat(greatestError(0.3, 0.2)).isBetween(0.005, 0.1);
  }
}
