package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.time.Duration;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
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

  private static Homes evening() {
    return new Homes("evening", "evening", 1, same -> same);
  }

  private static Result set(Homes homes, String member, String feature, String name, Object value) {
    return homes.call(member, feature, Map.of(name, value)).result().orElseThrow();
  }

  @Test
  void beginsAsTheSceneSays() {
    try (Homes homes = evening()) {
      assertThat(homes.facts("stereo"))
          .containsExactlyInAnyOrder(
              "(switchedOn stereo)",
              "(= (volume stereo) 50)",
              "(= (disc stereo) 1)",
              "(= (remaining stereo) 95)",
              "(playing stereo Lullaby)",
              "(source stereo disc-player)",
              "(not (muted stereo))",
              "(not (paused stereo))");
      assertThat(homes.facts("tv")).contains("(not (switchedOn tv))", "(source tv disc-player)");
      assertThat(homes.facts("front-door")).contains("(locked front-door)");
      assertThat(homes.facts("thermostat-living"))
          .containsExactly("(= (targetTemperature livingroom) 21)");
    }
  }

  @Test
  void keepsWhatIsSet() {
    try (Homes homes = evening()) {
      assertThat(set(homes, "stereo", "setVolume", "volume", 55).outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(set(homes, "stereo", "mute", "muted", true).outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.facts("stereo")).contains("(= (volume stereo) 55)", "(muted stereo)");

      assertThat(result(homes, "stereo", "switchOff").outcome()).isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.facts("stereo"))
          .contains("(not (switchedOn stereo))", "(= (volume stereo) 55)", "(= (disc stereo) 1)")
          .noneMatch(fact -> fact.startsWith("(playing"));
    }
  }

  @Test
  void takesSoLongAsItsSettingSays() {
    try (Homes homes = evening()) {
      Duration begun = homes.clock.now();
      set(homes, "stereo", "changeDisc", "disc", 3);

      assertThat(homes.clock.now().minus(begun))
          .isBetween(Duration.ofSeconds(3), Duration.ofSeconds(4));
      assertThat(homes.facts("stereo")).contains("(= (disc stereo) 3)");
    }
  }

  @Test
  void readsWhatIsInIt() {
    try (Homes homes = evening()) {
      assertThat(isThere(homes, "apple-1")).isTrue();
      assertThat(isThere(homes, "pasta-1")).as("it stands on the counter").isFalse();

      homes.world().hide("apple-1", false);
      homes.world().moveByHand("apple-1", new Position(7.1, 2.1, 0.72));
      assertThat(isThere(homes, "apple-1")).as("it was taken out").isFalse();
    }
  }

  private static boolean isThere(Homes homes, String food) {
    Object found =
        homes
            .call(
                "refrigerator",
                "takeStock",
                Map.of("object", Map.of("ref", "https://w3id.org/maestro/home/evening#" + food)))
            .values()
            .get("found");
    return Boolean.TRUE.equals(found);
  }

  @Test
  void refusesWhatItCannotBeSetTo() {
    try (Homes homes = evening()) {
      Result refused = set(homes, "stereo", "setVolume", "volume", 110);

      assertThat(refused.outcome()).isEqualTo(Outcome.FAILED);
      assertThat(refused.error().orElseThrow().message())
          .isEqualTo("The volume lies between 0 and 100, and is not 110.");
      assertThat(set(homes, "tv", "changeChannel", "channel", 7).outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(set(homes, "tv", "pause", "paused", true).error().orElseThrow().message())
          .isEqualTo("it is switched off");
    }
  }

  @Test
  void aLockKeepsADoorFromBeingOpened() {
    try (Homes homes = evening()) {
      assertThat(result(homes, "front-door", "openDoor").error().orElseThrow().message())
          .contains("locked");
      assertThat(set(homes, "front-door", "unlockDoor", "locked", false).outcome())
          .isEqualTo(Outcome.SUCCEEDED);
      assertThat(homes.facts("front-door")).contains("(not (locked front-door))");
      assertThat(result(homes, "front-door", "openDoor").outcome()).isEqualTo(Outcome.SUCCEEDED);
    }
  }

  @Test
  void aLampHasAColourBesideItsLevel() {
    try (Homes homes = evening()) {
      set(homes, "floor-lamp", "setColourTemperature", "colourTemperature", 4000);

      assertThat(homes.facts("floor-lamp"))
          .contains("(= (level floor-lamp) 0.5)", "(= (colourTemperature floor-lamp) 4000)");
    }
  }

  private static Result result(Homes homes, String member, String feature) {
    return homes.call(member, feature, Map.of()).result().orElseThrow();
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
