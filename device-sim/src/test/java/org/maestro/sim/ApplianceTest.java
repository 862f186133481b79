package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.ontology.home.Home;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.scene.Scene;
import org.maestro.sim.scene.ScriptedFault;
import org.maestro.sim.scene.SimulationException;

/** Appliances are switched, a television shows what is chosen, and a clock tells the time. */
class ApplianceTest {
  private static final Map<String, Object> THE_OPERA =
      Map.of("selection", Map.of("ref", "https://w3id.org/maestro/home/livingroom#Opera"));

  private static Homes livingRoom() {
    return new Homes("livingroom", "livingroom-evening", 1, same -> same);
  }

  private static Result result(Homes homes, String feature) {
    return homes
        .call("television", feature, feature.equals("selectShow") ? THE_OPERA : Map.of())
        .result()
        .orElseThrow();
  }

  @Test
  void showsWhatIsChosenUntilItIsSwitchedOff() {
    try (Homes homes = livingRoom()) {
      assertThat(homes.facts("television")).containsExactly("(not (switchedOn television))");

      assertThat(result(homes, "switchOn").outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.facts("television")).containsExactly("(switchedOn television)");

      assertThat(result(homes, "selectShow").outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.facts("television"))
          .containsExactly("(switchedOn television)", "(showing television Opera)");

      assertThat(result(homes, "switchOn").outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.facts("television")).contains("(showing television Opera)");

      assertThat(result(homes, "switchOff").outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.facts("television")).containsExactly("(not (switchedOn television))");
    }
  }

  @Test
  void showsNothingWhileItIsOff() {
    try (Homes homes = livingRoom()) {
      Result refused = result(homes, "selectShow");

      assertThat(refused.outcome()).isEqualTo(Outcome.FAILED);
      assertThat(refused.error().orElseThrow().message()).isEqualTo("it is switched off");
    }
  }

  @Test
  void aBrokenOneSaysSo() {
    try (Homes homes = livingRoom()) {
      homes.simulated.let("television", ScriptedFault.parse("at 1 break"));
      homes.clock.run(Duration.ofSeconds(2));

      assertThat(result(homes, "switchOn").outcome()).isEqualTo(Outcome.FAILED);
      assertThat(homes.facts("television")).containsExactly("(not (switchedOn television))");
    }
  }

  @Test
  void aClockTellsEachMinuteAlsoBeyondMidnight() {
    try (Homes homes = livingRoom()) {
      assertThat(homes.facts("wall-clock")).containsExactly("(= (minuteOfDay wall-clock) 1215)");

      homes.clock.run(Duration.ofMinutes(1));
      assertThat(homes.facts("wall-clock")).containsExactly("(= (minuteOfDay wall-clock) 1216)");

      homes.clock.run(Duration.ofMinutes(226));
      assertThat(homes.facts("wall-clock")).containsExactly("(= (minuteOfDay wall-clock) 2)");
    }
  }

  @Test
  void aClockNeedsATime() {
    Home home = Homes.home("livingroom");
    Scene timeless = new Scene("timeless", Map.of());

    assertThatThrownBy(() -> new Homes(home, timeless, 1))
        .isInstanceOf(SimulationException.class)
        .hasMessageContaining(
            "does not say what time it is, which wall-clock shows. Give the home");
  }
}
