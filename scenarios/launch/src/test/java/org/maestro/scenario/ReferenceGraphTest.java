package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.List;
import java.util.Objects;
import java.util.TreeSet;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.function.Predicate;
import java.util.stream.StreamSupport;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.LocalSite;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.questions.AclQuestions;
import org.maestro.console.references.ReferenceGraph;
import org.maestro.console.references.ReferencesDocument;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/** Which of the running agents turns to which, and what they are for (ADE, 3.3 and 5; A39, A74). */
class ReferenceGraphTest {
  private static final String WATCHES = "watches ";
  private static final String EYE_HALL = "eye-hall/perception";
  private static final String EYE_LIVING = "eye-living/perception";
  private static final int SENSORS = 11;
  private static final int LOOKS = 40;
  private static final Duration BETWEEN_LOOKS = Duration.ofSeconds(5);
  private static final String TRACKER = "persons/perception";

  /** Three rooms of the people's house that listen. */
  private static final String ROOMS =
      """

      home:living-agent a maestro:RoomAgent ; rdfs:label "the living room's agent"@en ;
        maestro:hears home:livingroom ; maestro:memberWhen "(inside ?member livingroom)" ;
        maestro:understands :people .
      home:kitchen-agent a maestro:RoomAgent ; rdfs:label "the kitchen's agent"@en ;
        maestro:hears home:kitchen ; maestro:memberWhen "(inside ?member kitchen)" ;
        maestro:understands :people .
      home:hall-agent a maestro:RoomAgent ; rdfs:label "the hallway's agent"@en ;
        maestro:hears home:hallway ; maestro:memberWhen "(inside ?member hallway)" .
      """;

  /** A room of Bob's home that listens, and something that is done with feeling. */
  private static final String FEELING =
      """

      home:ears a maestro:RoomAgent ; rdfs:label "the ears of room A"@en ; maestro:hears home:room-a ;
        maestro:memberWhen "(inside ?member zone-a)" .
      home:cheer a maestro:Script ; rdfs:label "cheer"@en ; maestro:sentence "cheer" ;
        maestro:arguments ( ) ; maestro:body "(express glad 0.8)" .
      """;

  private static Stage stage(String home, String scene, String more) {
    Home read = new HomeLoader().load(text("/homes/" + home + ".ttl") + more, home + ".ttl");
    byte[] turtle = text("/scenes/" + scene + ".ttl").getBytes(StandardCharsets.UTF_8);
    return Stage.stepped(
        SiteSettings.of(home + "-" + UUID.randomUUID(), read)
            .scene(SceneLoader.load(scene, new ByteArrayInputStream(turtle), read))
            .build());
  }

  private static String text(String name) {
    try (InputStream resource =
        Objects.requireNonNull(LocalSite.class.getResourceAsStream(name), name)) {
      return new String(resource.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static JsonNode graph(Stage stage) {
    CompletableFuture<JsonNode> agents = new AclQuestions(stage.platform().desk()).agents();
    stage.await("the agents are told", agents::isDone);
    return ReferencesDocument.of(
        new ReferenceGraph(agents.join(), stage.knowledge().home(), stage.knowledge().snapshot()));
  }

  /** The first graph that is so; time passes between two of them. */
  private static JsonNode graph(Stage stage, String what, Predicate<JsonNode> isSo) {
    JsonNode graph = graph(stage);
    for (int looks = 0; looks < LOOKS && !isSo.test(graph); looks++) {
      stage.run(BETWEEN_LOOKS);
      graph = graph(stage);
    }
    assertThat(isSo.test(graph)).as("%s: %s", what, graph).isTrue();
    return graph;
  }

  private static List<JsonNode> references(JsonNode graph) {
    return StreamSupport.stream(graph.path("references").spliterator(), false).toList();
  }

  private static List<String> from(JsonNode graph, String component, String purpose) {
    return references(graph).stream()
        .filter(one -> one.path("from").asText().equals(component))
        .filter(one -> one.path("purpose").asText().startsWith(purpose))
        .map(one -> one.path("to").asText())
        .toList();
  }

  private static List<String> to(JsonNode graph, String component, String purpose) {
    return references(graph).stream()
        .filter(one -> one.path("to").asText().equals(component))
        .filter(one -> one.path("purpose").asText().startsWith(purpose))
        .map(one -> one.path("from").asText())
        .toList();
  }

  @Test
  void oneTrackerWatchesByAllRoomsSensorsAndIsAskedByAllRooms() {
    try (Stage stage = stage("people", "people", ROOMS)) {
      JsonNode graph =
          graph(
              stage,
              "all rooms' sensors have told something",
              now -> from(now, TRACKER, WATCHES).size() >= SENSORS);
      assertThat(from(graph, TRACKER, WATCHES))
          .contains(EYE_HALL, EYE_LIVING, "radar-kids/perception");
      assertThat(
              references(graph).stream()
                  .filter(one -> one.path("from").asText().equals(TRACKER))
                  .map(one -> one.path("purpose").asText())
                  .filter(purpose -> purpose.startsWith(WATCHES))
                  .toList())
          .contains(
              "watches hallway",
              "watches livingroom",
              "watches kitchen",
              "watches bathroom",
              "watches bedroom",
              "watches kidsroom");
      assertThat(to(graph, TRACKER, "asks where persons are"))
          .containsExactlyInAnyOrder(
              "hall-agent/language", "kitchen-agent/language", "living-agent/language");
      assertThat(from(graph, "hall-agent/language", "passes on"))
          .containsExactlyInAnyOrder("kitchen-agent/language", "living-agent/language");
      stage.await("Tom is known", () -> isKnown(stage, "(probablyIn Tom kidsroom)"));
      stage.speaker("Rose").in("kitchen").says("where is Tom?").replies("The kids' room.");
    }
  }

  private static boolean isKnown(Stage stage, String fact) {
    return stage.knowledge().snapshot().beliefs().stream()
        .anyMatch(belief -> belief.fact().equals(fact));
  }

  @Test
  void whoIsTakenAwayIsReferredToNoMore() {
    try (Stage stage = stage("people", "people", ROOMS)) {
      graph(
          stage,
          "both cameras have told something",
          now -> from(now, TRACKER, WATCHES).containsAll(List.of(EYE_HALL, EYE_LIVING)));

      stage.kill("eye-hall");
      JsonNode without =
          graph(
              stage,
              "it is missed",
              now ->
                  !from(now, TRACKER, WATCHES).contains(EYE_HALL)
                      && !now.path("components").findValuesAsText("id").contains(EYE_HALL));
      assertThat(without.path("components").findValuesAsText("id"))
          .contains(EYE_LIVING)
          .doesNotContain(EYE_HALL);
      assertThat(from(without, TRACKER, WATCHES)).contains(EYE_LIVING);

      stage.platform().endAgent("CCA");
      JsonNode headless =
          graph(
              stage,
              "there is no central agent",
              now -> !now.path("components").findValuesAsText("agent").contains("CCA"));
      assertThat(from(headless, "kitchen-agent/language", "states what is wanted"))
          .as("it does itself what it can")
          .containsExactly("kitchen-agent/cognition");
    }
  }

  @Test
  void affectCognitionReflectionPerceptionNavigationActionAndLanguageAreRunning() {
    try (Stage stage = stage("bob", "bob-dark", FEELING)) {
      stage.await(
          "all devices are there", () -> stage.platform().presentMembers().contains("rose"));

      JsonNode graph = graph(stage);
      assertThat(new TreeSet<>(graph.path("components").findValuesAsText("faculty")))
          .containsExactly(
              "action",
              "affect",
              "cognition",
              "language",
              "navigation",
              "perception",
              "reflection");
      assertThat(from(graph, "CCA/cognition", "calls"))
          .contains("rose/navigation", "rose/action", "cam-a/perception", "lamp-a1/action")
          .doesNotContain("lamp-a1/navigation", "cam-a/action");
      assertThat(from(graph, "ears/cognition", "calls"))
          .contains("cam-a/perception")
          .doesNotContain("cam-b/perception");
      assertThat(from(graph, "CCA/cognition", "shows moods")).containsExactly("CCA/affect");
      assertThat(from(graph, "supervisor/reflection", "")).anyMatch(to -> to.startsWith("CCA/"));
      assertThat(from(graph, "CCA/reflection", "tells why")).containsExactly("CCA/cognition");
    }
  }
}
