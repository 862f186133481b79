package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.content.Words;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.platform.AgentRow;
import org.maestro.platform.jade.SentMessage;
import org.maestro.sim.scene.SceneLoader;

/** Agents with goals of their own, held goals, and the death of the central agent. */
class OwnAccordTest {
  private static final String CENTRE = "CCA";
  static final String KEEPER =
      """

      home:keeper a maestro:GroupAgent ; rdfs:label "the keeper of B's light" ;
        maestro:memberWhen "(inside ?member zone-b)" ;
        maestro:pursues "(keep (>= (illuminance zone-b) 72))" .
      """;

  private static final String TEAM =
      """

      home:team a maestro:GroupAgent ; rdfs:label "all devices" ;
        maestro:memberWhen "(Device ?member)" ; maestro:pursues "(nextTo Cup Bob)" .
      """;
  private static final String LAMP_WITH_A_WISH =
      ":Lamp ; rdfs:label \"lamp B1\"@en ; maestro:pursues \"(nextTo Cup Bob)\" ;";

  @Test
  void aGroupKeepsItsRoomLitWithoutTheCentralAgent() {
    try (Stage stage = stage("keeper", KEEPER)) {
      List<StoryEntry> story = listen(stage);
      stage.platform().endAgent(CENTRE);
      stage.await("the room is lit", () -> stage.world().lux("zone-b") >= 72);

      stage.world().setAmbient("zone-b", 60);
      stage.await("lamps are dimmed", () -> stage.world().lux("zone-b") < 100);
      stage.world().setAmbient("zone-b", 5);
      stage.await("the room is dark", () -> stage.world().lux("zone-b") < 72);
      stage.await("the room is lit again", () -> stage.world().lux("zone-b") >= 72);

      assertThat(story).extracting(StoryEntry::goalId).containsOnly("keeper-1");
      assertThat(stage.world().lampLevel("lamp-a1")).isEqualTo(1);
    }
  }

  /**
   * A stored value is enough: the lamps' group acts on what the sensor has stored, and nobody but
   * the store is sent it (Three-layered architecture, 2; M15).
   */
  @Test
  void aStoredLuxValueHasTheLampsLitAndIsToldToNobodyByAMessage() {
    try (Stage stage = stage("silent", KEEPER)) {
      stage.platform().endAgent(CENTRE);
      stage.await("the room is lit", () -> stage.world().lux("zone-b") >= 72);
      stage.run(Duration.ofSeconds(5));
      double before = stage.world().lampLevel("lamp-b1") + stage.world().lampLevel("lamp-b2");
      List<SentMessage> mail = new CopyOnWriteArrayList<>();
      Runnable end = stage.platform().onMail(mail::add);

      stage.world().setAmbient("zone-b", 60);
      stage.await(
          "the lamps are dimmed",
          () -> stage.world().lampLevel("lamp-b1") + stage.world().lampLevel("lamp-b2") < before);
      end.run();

      List<SentMessage> beforeItActed =
          mail.stream()
              .filter(message -> !isJadesOwn(message))
              .takeWhile(message -> !message.sender().startsWith("keeper@"))
              .toList();
      assertThat(beforeItActed)
          .as("the sensor has its value stored, and nobody else is told anything")
          .isNotEmpty()
          .allMatch(message -> message.sender().startsWith("lux-"))
          .allMatch(message -> message.receiver().startsWith("knowledge@"))
          .anyMatch(message -> message.sender().startsWith("lux-b@"));
    }
  }

  /** The yellow pages are told of containers and agents whenever JADE comes to it. */
  private static boolean isJadesOwn(SentMessage message) {
    return message.sender().startsWith("ams@") && message.receiver().startsWith("df@");
  }

  /** Its goal is the same after a restart, and what it has learnt for it. */
  @Test
  void aGroupGoesOnWithItsGoalAfterARestart(@TempDir Path data) {
    try (Stage stage = Stage.stepped(remembering("before", data))) {
      stage.await("the room is lit", () -> stage.world().lux("zone-b") >= 72);
      stage.run(Duration.ofSeconds(5));
    }

    try (Stage stage = Stage.stepped(remembering("after", data))) {
      List<StoryEntry> story = listen(stage);
      stage.await("the room is lit again", () -> stage.world().lux("zone-b") >= 72);
      stage.run(Duration.ofSeconds(5));

      assertThat(story).extracting(StoryEntry::goalId).containsOnly("keeper-1");
      assertThat(story).noneMatch(entry -> entry.kind() == StoryEntry.Kind.GOAL);
      assertThat(story).anyMatch(entry -> entry.text().startsWith("It is so again"));
    }
  }

  @Test
  void whatItsMembersLackADeviceAsksOfOthersAsAnEffect() {
    String wish =
        "maestro:pursues \"(keep (exists (?z - Zone) (and (in ?self ?z) (>= (illuminance ?z)"
            + " 72))))\" ; :speed 0.8";
    try (Stage stage = stage("asking", "", ":speed 0.8", wish)) {
      List<StoryEntry> story = listen(stage);
      stage.await("it is light where Rose is", () -> stage.world().lux("zone-b") >= 72);

      assertThat(story)
          .anyMatch(
              entry -> entry.goalId().startsWith("G") && entry.text().startsWith("rose asks for"));
      assertThat(story).noneMatch(entry -> entry.text().matches(".*lamp-a. is set to.*"));
    }
  }

  /** All devices as one group fetch the cup themselves; cancelled, Rose reaches for it no more. */
  @Test
  void withoutTheCentralAgentACancelledGoalEndsSafe() {
    try (Stage stage = stage("team", TEAM)) {
      stage.platform().endAgent(CENTRE);
      List<StoryEntry> story = listen(stage);
      stage.await(
          "Rose reaches for the cup",
          () ->
              story.stream()
                  .anyMatch(entry -> entry.text().matches("Step \\d+ of \\d+: rose picks up.*")));
      stage.run(Duration.ofSeconds(2));
      List<Integer> answers = new CopyOnWriteArrayList<>();
      stage
          .platform()
          .desk()
          .request(
              ACLMessage.REQUEST,
              "team",
              Duration.ofSeconds(30),
              reply -> answers.add(reply.getPerformative()),
              Words.content("cancel", Words.named("goal", Words.name("team-1"))));

      stage.await("it is cancelled", () -> !answers.isEmpty());
      stage.await("Rose is in a safe state", () -> state(stage, "rose").equals("safe"));
      Optional<String> zone = stage.world().zone("rose");
      stage.run(Duration.ofSeconds(20));

      assertThat(answers).containsExactly(ACLMessage.INFORM);
      assertThat(stage.world().holder("Cup")).isEmpty();
      assertThat(stage.world().zone("rose")).isEqualTo(zone);
      assertThat(state(stage, "rose")).isEqualTo("safe");
      assertThat(story).extracting(StoryEntry::goalId).containsOnly("team-1");
    }
  }

  private static String state(Stage stage, String agent) {
    return stage.platform().agents().stream()
        .filter(row -> row.agent().equals(agent))
        .map(AgentRow::state)
        .findFirst()
        .orElse("");
  }

  /**
   * A lamp can neither see nor carry; it asks for what others are able to do (Three-layered
   * architecture, 2; M14).
   */
  @Test
  void aLampHasTheCupBroughtToBob() {
    try (Stage stage = stage("lamp", "", ":Lamp ; rdfs:label \"lamp B1\"@en ;", LAMP_WITH_A_WISH)) {
      List<StoryEntry> story = listen(stage);
      stage.await("the cup is with Bob", () -> stage.world().isNextTo("Cup", "Bob"));

      assertThat(story)
          .anyMatch(
              entry ->
                  entry.goalId().startsWith("G") && entry.text().startsWith("lamp-b1 asks for"));
      assertThat(story).anyMatch(entry -> entry.text().contains("rose picks up"));
    }
  }

  @Test
  void aLampSaysWhatItsWishIsWorth() {
    String wish =
        ":Lamp ; rdfs:label \"lamp B1\"@en ; maestro:pursues \"(>= (level ?self) 0.5)\" ;"
            + " maestro:benefit \"(+ 60 (level ?self))\" ; maestro:chance 0.5 ;";
    try (Stage stage = stage("worth", "", ":Lamp ; rdfs:label \"lamp B1\"@en ;", wish)) {
      List<StoryEntry> story = listen(stage);
      stage.await("the lamp is lit", () -> stage.world().lampLevel("lamp-b1") >= 0.5);

      assertThat(story)
          .anyMatch(
              entry ->
                  entry.goalId().equals("lamp-b1-1")
                      && entry.text().startsWith("Worth: u = 0.5·60 − "));
    }
  }

  @Test
  void theGoalsOfACentralAgentGoOnWithTheNextOne() {
    try (Stage stage = stage("heirs", "")) {
      Pursuit light = stage.begin("(keep (>= (illuminance zone-b) 72))");
      stage.await("the room is lit", () -> stage.world().lux("zone-b") >= 72);
      Pursuit fetch = stage.begin("(nextTo Cup Bob)").awaitTelling(": rose picks up");

      assertThat(stage.world().holder("Cup")).isEmpty();
      stage.platform().endAgent(CENTRE);

      stage.await(
          "what Rose is at is done to its end",
          () -> stage.world().holder("Cup").equals(Optional.of("rose")));
      assertThat(fetch.await().reached()).isFalse();
      assertThat(light.await().explanation()).contains("no central coordination agent");
      assertThat(stage.goal("(nextTo Cup Bob)").explanation()).contains("revive");
      stage.run(Duration.ofSeconds(30));
      assertThat(stage.platform().reviveCoordinator()).isTrue();
      assertThat(stage.platform().reviveCoordinator()).isFalse();
      stage.await("the cup is with Bob", () -> stage.world().isNextTo("Cup", "Bob"));
      stage.world().setAmbient("zone-b", 0);
      stage.await("the room is dark", () -> stage.world().lux("zone-b") < 72);
      stage.await("the room is lit again", () -> stage.world().lux("zone-b") >= 72);
    }
  }

  private static List<StoryEntry> listen(Stage stage) {
    List<StoryEntry> story = new CopyOnWriteArrayList<>();
    stage.platform().onStory(story::add);
    return story;
  }

  private static Stage stage(String name, String more) {
    return stage(name, more, "", "");
  }

  private static Stage stage(String name, String more, String instead, String by) {
    return Stage.stepped(site(name, more, instead, by));
  }

  private static SiteSettings remembering(String name, Path data) {
    return site(name, KEEPER, "", "").but().dataDirectory(data).build();
  }

  static SiteSettings site(String name, String more, String instead, String by) {
    Home home =
        new HomeLoader().load(text("/homes/bob.ttl").replace(instead, by) + more, "bob.ttl");
    String scene = text("/scenes/bob-dark.ttl");
    return SiteSettings.of(name, home)
        .scene(
            SceneLoader.load(
                "the scene",
                new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8)),
                home))
        .build();
  }

  private static String text(String path) {
    try (InputStream stream = OwnAccordTest.class.getResourceAsStream(path)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
