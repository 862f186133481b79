package org.maestro.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.maestro.hal.Position;
import org.maestro.ontology.home.Home;
import org.maestro.rats.link.RatsLink;
import org.maestro.rats.protocol.Observation;
import org.maestro.rats.protocol.Outcome;
import org.maestro.rats.protocol.Result;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sim.scene.ScriptedFault;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.world.Talk;

/**
 * What is said is heard by the microphones of the room, and loudspeakers say what they are told.
 */
class SpeechTest {

  /** What a microphone tells to who has it listen. */
  private static final class Heard implements RatsLink.CallListener {
    private final Homes homes;
    private final Duration begun;
    private final List<Map<String, Object>> hypotheses = new ArrayList<>();
    private final List<Double> seconds = new ArrayList<>();
    private Optional<Result> end = Optional.empty();

    Heard(Homes homes) {
      this.homes = homes;
      this.begun = homes.clock.now();
      RatsLink.CallHandle unusedAsItListensForEver =
          homes.link.call(
              "microphone", "listen", Map.of(), Duration.ofSeconds(60), Optional.empty(), this);
    }

    @Override
    public void observed(Observation observation) {
      hypotheses.add(observation.values());
      seconds.add(homes.clock.now().minus(begun).toMillis() / 1e3);
    }

    @Override
    public void ended(Result result) {
      end = Optional.of(result);
    }

    private List<String> words() {
      return hypotheses.stream().map(one -> String.valueOf(one.get("words"))).toList();
    }

    private Map<String, Object> last() {
      return hypotheses.get(hypotheses.size() - 1);
    }
  }

  private static Homes parlour(Map<String, String> physics) {
    Home home = Homes.home("parlour");
    return new Homes(home, Homes.scene("parlour", home), 1, usual -> usual.with(physics));
  }

  private static Homes clearly() {
    return parlour(Map.of("world.speech.reviseShare", "0"));
  }

  private static Heard listening(Homes homes, String text) {
    Heard heard = new Heard(homes);
    homes.world().talk().say("Dave", text);
    homes.clock.run(Duration.ofSeconds(10));
    return heard;
  }

  @Test
  void eachWordIsToldWithAllBeforeItAndTheEndTwice() {
    try (Homes homes = clearly()) {
      Heard heard = listening(homes, "turn on the light");

      assertThat(heard.words())
          .containsExactly(
              "turn",
              "turn on",
              "turn on the",
              "turn on the light",
              "turn on the light",
              "turn on the light");
      assertThat(heard.hypotheses.stream().map(one -> one.get("over")))
          .containsExactly(false, false, false, false, true, true);
      assertThat(heard.hypotheses).allMatch(one -> one.get("speaker").equals("Dave"));
      assertThat(heard.last().get("alternatives"))
          .isEqualTo(List.of(List.of("tarn"), List.of("un"), List.of("thi"), List.of("loght")));
      for (int word = 1; word < 4; word++) {
        assertThat(heard.seconds.get(word) - heard.seconds.get(word - 1)).isBetween(0.29, 0.31);
      }
      assertThat(heard.seconds.get(4) - heard.seconds.get(3)).isBetween(0.69, 0.71);
    }
  }

  /** How a word is heard is only certain when the next one was. */
  @Test
  void aWordMayBeHeardOtherwiseUntilTheNext() {
    try (Homes homes = parlour(Map.of("world.speech.reviseShare", "1"))) {
      Heard heard = listening(homes, "turn on the light");

      assertThat(heard.words())
          .containsExactly(
              "tarn",
              "turn un",
              "turn on thi",
              "turn on the loght",
              "turn on the light",
              "turn on the light");
      assertThat(heard.hypotheses.get(2).get("stable")).isEqualTo(2);
      assertThat(heard.last().get("stable")).isEqualTo(4);
    }
  }

  @Test
  void aWordThatIsMisheardStaysSo() {
    try (Homes homes = parlour(Map.of("world.speech.mishearShare", "1"))) {
      assertThat(listening(homes, "stop").last().get("words")).isEqualTo("stup");
    }
  }

  /** Whatever of it is lost, the last that comes is the whole. */
  @Test
  void whatIsLostOnTheWayIsHealedByTheNext() {
    try (Homes homes = clearly()) {
      Heard heard = new Heard(homes);
      homes.clock.run(Duration.ofSeconds(1));
      homes.simulated.let("microphone", ScriptedFault.parse("at 0.001 lose 0.5"));
      homes.world().talk().say("Dave", "turn on the light in the parlour please");
      homes.clock.run(Duration.ofSeconds(10));

      assertThat(heard.hypotheses).hasSizeBetween(1, 9);
      assertThat(heard.last().get("words")).isEqualTo("turn on the light in the parlour please");
    }
  }

  @Test
  void whoIsElsewhereIsNotHeard() {
    try (Homes homes = clearly()) {
      homes.world().moveByHand("Dave", new Position(20, 20, 0));
      assertThat(listening(homes, "turn on the light").hypotheses).isEmpty();
    }
  }

  @Test
  void aBrokenMicrophoneFailsWhenItShouldHear() {
    try (Homes homes = clearly()) {
      homes.world().breakDown("microphone", "its cable is torn");
      Heard heard = listening(homes, "turn on the light");
      assertThat(heard.end.orElseThrow().error().orElseThrow().message())
          .contains("its cable is torn");
    }
  }

  @Test
  void aLoudspeakerSaysOneSentenceAfterTheOther() {
    try (Homes homes = clearly()) {
      Duration begun = homes.clock.now();
      Result said =
          homes
              .call("loudspeaker", "sayAloud", Map.of("text", "The light is on."))
              .result()
              .orElseThrow();

      assertThat(said.outcome()).isEqualTo(Outcome.SUCCEEDED);
      Talk.Sounded sounded = homes.world().talk().sounded().get(0);
      assertThat(sounded.text()).isEqualTo("The light is on.");
      assertThat(sounded.zone()).isEqualTo("parlour");
      assertThat(sounded.at().minus(begun))
          .isBetween(Duration.ofMillis(1600), Duration.ofMillis(1700));
    }
  }

  @Test
  void aLoudspeakerIsToldWhatToSay() {
    try (Homes homes = clearly()) {
      Result refused =
          homes.call("loudspeaker", "sayAloud", Map.of("text", "  ")).result().orElseThrow();
      assertThat(refused.error().orElseThrow().message())
          .isEqualTo("The parameter text is what is to be said, of 1 to 2000 characters.");
    }
  }

  private static String scene(String says) {
    return """
    @base <https://w3id.org/maestro/home/parlour> .
    @prefix scene: <https://w3id.org/maestro/scene#> .
    <#Dave> scene:position "1.4 2.4 0" ; scene:says "%s" .
    """
        .formatted(says);
  }

  @Test
  void aSceneSaysWhoSaysWhatAndWhen() {
    Home home = Homes.home("parlour");
    byte[] scene = scene("at 2 hello; at 5.5 turn on the light").getBytes(StandardCharsets.UTF_8);
    try (Homes homes =
        new Homes(home, SceneLoader.load("my-scene", new ByteArrayInputStream(scene), home), 1)) {
      Heard heard = new Heard(homes);
      homes.clock.run(Duration.ofSeconds(12));
      assertThat(heard.hypotheses.stream().filter(one -> one.get("over").equals(true)))
          .extracting(one -> one.get("words"))
          .containsExactly("hello", "hello", "turn on the light", "turn on the light");
    }
  }

  @Test
  void aSceneThatDoesNotSayWhenIsRefused() {
    Home home = Homes.home("parlour");
    byte[] scene = scene("turn on the light").getBytes(StandardCharsets.UTF_8);
    assertThatThrownBy(() -> SceneLoader.load("my-scene", new ByteArrayInputStream(scene), home))
        .isInstanceOf(SimulationException.class)
        .hasMessageContaining("at 12 turn on the light");
  }
}
