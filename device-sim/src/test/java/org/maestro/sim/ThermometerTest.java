package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.scene.ScriptedFault;

/** How warm a room is follows from its thermostat and from outdoors, and a thermometer tells it. */
class ThermometerTest {
  private static final String ZONE = "parlour";

  private static Homes parlour(UnaryOperator<PhysicalParameters> physics) {
    Home home = Homes.home("parlour");
    return new Homes(home, Homes.scene("parlour", home), 1, physics);
  }

  private static Homes exactly() {
    return parlour(usual -> usual.with(Map.of("world.thermometer.noise", "0")));
  }

  private static double told(Homes homes) {
    List<String> facts = homes.facts("thermometer");
    assertThat(facts).hasSize(1);
    assertThat(facts.get(0)).matches("\\(= \\(temperature parlour\\) [0-9.]+\\)");
    return Double.parseDouble(facts.get(0).replaceAll(".* |\\)", ""));
  }

  private static void set(Homes homes, double celsius) {
    homes.call("thermostat", "setTargetTemperature", Map.of("target", celsius));
  }

  @Test
  void tellsAsTheSceneSaysInTheBeginning() {
    try (Homes homes = exactly()) {
      assertThat(told(homes)).isEqualTo(19);
      assertThat(homes.world().climate().outside()).isEqualTo(2);
    }
  }

  /** In two hours 100 W a square metre, less what is lost, make it (100 - 1.5 * 17) / 46 K/h. */
  @Test
  void becomesAsWarmAsTheThermostatIsSetAndStaysSo() {
    try (Homes homes = exactly()) {
      set(homes, 22);
      homes.clock.run(Duration.ofHours(1));
      assertThat(homes.world().celsius(ZONE)).isCloseTo(19 + 74.5 / 46, within(0.1));

      homes.clock.run(Duration.ofHours(3));
      for (int hour = 0; hour < 6; hour++) {
        homes.clock.run(Duration.ofHours(1));
        assertThat(homes.world().celsius(ZONE)).isCloseTo(22, within(0.26));
        assertThat(told(homes)).isCloseTo(homes.world().celsius(ZONE), within(0.21));
      }
    }
  }

  @Test
  void coolsTowardsOutdoorsWhenTheThermostatHasNoPower() {
    try (Homes homes = exactly()) {
      homes.simulated.let("thermostat", ScriptedFault.parse("at 1 die"));
      homes.clock.run(Duration.ofHours(10));

      double left = Math.exp(-10 / (46 / 1.5));
      assertThat(homes.world().celsius(ZONE)).isCloseTo(2 + 17 * left, within(0.01));
    }
  }

  /** What it told counts for half an hour only; it tells again before. */
  @Test
  void tellsNowAndThenThoughNothingChanges() {
    try (Homes homes = parlour(usual -> usual)) {
      set(homes, 19);
      homes.clock.run(Duration.ofHours(3));
      double before = told(homes);
      homes.clock.run(Duration.ofMinutes(12));
      assertThat(told(homes)).isNotEqualTo(before).isCloseTo(before, within(0.5));
    }
  }

  @Test
  void tellsAnotherTemperatureWhenItLies() {
    try (Homes homes = exactly()) {
      homes.simulated.let("thermometer", ScriptedFault.parse("at 1 lie 1.5"));
      homes.clock.run(Duration.ofMinutes(2));
      assertThat(told(homes)).isCloseTo(1.5 * homes.world().celsius(ZONE), within(0.1));
    }
  }

  @Test
  void aSceneMaySayTheWarmthOfZonesAndOutdoorsOnly() {
    Home home = Homes.home("parlour");
    String scene =
        """
        @base <https://w3id.org/maestro/home/parlour> .
        @prefix scene: <https://w3id.org/maestro/scene#> .
        <#lamp> scene:celsius 20 .
        <#parlour> scene:celsius 61 .
        """;
    assertThat(SceneLoader.check("my-scene", scene, home).faults())
        .singleElement()
        .satisfies(fault -> assertThat(fault.problem()).contains("scene:celsius 61"));
    assertThat(SceneLoader.check("my-scene", scene.replace("61", "20"), home).warnings())
        .singleElement()
        .satisfies(fault -> assertThat(fault.problem()).contains("scene:celsius of lamp"));
  }
}
