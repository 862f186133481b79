package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.questions.AgentOrder;
import org.maestro.junit.Speaker;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/** A room with its agent and its devices is added to a house that runs, and removed (A96). */
@Isolated("its time is wall time, which others beside it would take")
class AddedRoomTest {
  private static final String ROOMS = text("/homes/rooms.ttl");
  private static final String AGENT = block("home:bedroom-agent a");
  private static final String LAMP = block("home:bed-lamp a");
  private static final String THERMOSTAT = block("home:thermostat-bed a");
  private static final String FILE =
      ROOMS.substring(
              ROOMS.indexOf("@prefix"), ROOMS.indexOf("<https://w3id.org/maestro/home/rooms> a"))
          + AGENT
          + LAMP
          + THERMOSTAT;
  private static final String WARMER = "heat the bedroom to 21 degrees";

  private static String text(String name) {
    try (InputStream resource =
        Objects.requireNonNull(LocalSite.class.getResourceAsStream(name), name)) {
      return new String(resource.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** All that the home says of one thing. */
  private static String block(String begin) {
    int at = ROOMS.indexOf(begin);
    return ROOMS.substring(at, ROOMS.indexOf(" .\n", at) + 3);
  }

  private static Stage stage() {
    Home home = new HomeLoader().load(ROOMS.replace(AGENT, ""), "rooms.ttl");
    byte[] scene = text("/scenes/rooms.ttl").getBytes(StandardCharsets.UTF_8);
    return Stage.paced(
        SiteSettings.of("rooms-" + UUID.randomUUID(), home)
            .scene(SceneLoader.load("rooms", new ByteArrayInputStream(scene), home))
            .build());
  }

  private static List<String> order(Stage stage, AgentOrder order) throws Exception {
    JsonNode told =
        new AclQuestions(stage.platform().desk()).order(order).get(60, TimeUnit.SECONDS);
    List<String> sentences = new ArrayList<>();
    told.path("told").forEach(sentence -> sentences.add(sentence.asText()));
    return sentences;
  }

  private static AgentOrder.Add add(String text) {
    return new AgentOrder.Add(text, "bedroom.ttl", Optional.empty(), Optional.empty(), List.of());
  }

  @Test
  void itHearsUnderstandsAndActsAtOnceAndOtherRoomsPassWordsOnToItUntilItIsRemoved()
      throws Exception {
    try (Stage stage = stage()) {
      stage.await("all are there", () -> stage.platform().presentMembers().contains("bed-lamp"));
      for (String device : List.of("bed-lamp", "thermostat-bed")) {
        order(stage, new AgentOrder.Remove(device));
      }
      stage.await("it is gone", () -> !stage.platform().presentMembers().contains("bed-lamp"));
      Speaker inBath = stage.speaker("Rose").in("bathroom");
      inBath.says(WARMER).isRefused("");

      assertThat(order(stage, add(FILE)))
          .containsExactlyInAnyOrder(
              "The agent bed-lamp lives in lights.",
              "The agent thermostat-bed lives in appliances.",
              "The agent bedroom-agent lives in groups, and hears what is said in bedroom.");
      stage.await("they are there", () -> stage.platform().presentMembers().contains("bed-lamp"));

      Speaker inBed = stage.speaker("Dave").in("bedroom");
      inBed
          .says("turn on the light")
          .isUnderstoodHere()
          .means("(initCNP (:goal (= (level bed-lamp) 1)))")
          .isReached();
      inBath.says(WARMER).isPassedOnTo("bedroom-agent").isReached();
      assertThatThrownBy(() -> order(stage, add(FILE)))
          .hasMessageContaining("has the name of something else in the home");

      assertThat(order(stage, new AgentOrder.Remove("bedroom-agent")))
          .containsExactly("The agent bedroom-agent is removed.");
      inBath.says(WARMER).isRefused("");
      assertThat(stage.platform().directory().find("bedroom-agent")).isEmpty();
      assertThat(stage.knowledge().home().listener("bedroom")).isEmpty();
    }
  }
}
