package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.maestro.agents.content.AskedGoal;
import org.maestro.assembly.SiteSettings;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/**
 * A group agent with goals of its own and the central agent want the gripper of the only robot
 * (ADE, 6; A94).
 */
class SeveralGoalManagersTest {
  private static final String MUG =
      """

      home:Mug a :Item ; rdfs:label "the mug"@en ; :colour "green" ; :size "0.08 0.08 0.1" ; :mass 0.25 .
      home:team a maestro:GroupAgent ; rdfs:label "all devices" ;
        maestro:memberWhen "(Device ?member)" ; maestro:pursues "(nextTo Cup Bob)" .
      """;
  private static final String WHERE_IT_IS =
      """

      <#Mug> scene:position "5.2 0.9 0" ; scene:radius 0.04 ; scene:mass 0.25 .
      """;

  @Test
  void theSecondWaitsForTheGripperSaysWhoHasItAndGetsItAfterwards() {
    try (Stage stage = stage("both")) {
      List<StoryEntry> story = listen(stage);
      awaitTelling(stage, story, "team-1", ": rose picks up");
      Pursuit mug = stage.begin("(nextTo Mug Bob)");
      awaitTelling(stage, story, "G1", "of rose is held by team-1");

      assertThat(mug.await().reached()).as(told(story)).isTrue();
      assertThat(stage.world().isNextTo("Cup", "Bob")).isTrue();
      assertThat(stage.world().isNextTo("Mug", "Bob")).isTrue();
      assertThat(story)
          .anyMatch(
              entry ->
                  entry.goalId().equals("G1")
                      && entry.text().endsWith("has what it needs of rose, for team-1."));
    }
  }

  /** Rose is on her way to the cup, and has nothing in her hand. */
  @Test
  void whoGoesFirstGetsItAtASafePointAndTheOtherGoesOnAfterwards() {
    try (Stage stage = stage("first")) {
      List<StoryEntry> story = listen(stage);
      Pursuit mug = overtaking(stage, story);
      mug.await();

      assertThat(stage.world().isNextTo("Cup", "Bob")).as(told(story)).isFalse();
      assertThat(stage.world().isNextTo("Mug", "Bob")).isTrue();
      stage.await("the cup is brought, too", () -> stage.world().isNextTo("Cup", "Bob"));
      assertThat(tells(story, "team-1", "Goes on.")).isTrue();
    }
  }

  /** Rose has the mug in her hand when its manager dies. */
  @Test
  void whatADeadManagerHadTheOtherGetsAndNothingIsLost() {
    try (Stage stage = stage("dead")) {
      List<StoryEntry> story = listen(stage);
      overtaking(stage, story);
      stage.await(
          "Rose has the mug", () -> stage.world().holder("Mug").equals(Optional.of("rose")));
      stage.platform().endAgent("CCA");

      stage.await("the cup is with Bob", () -> stage.world().isNextTo("Cup", "Bob"));
      assertThat(stage.world().isNextTo("Mug", "Bob")).as(told(story)).isFalse();
      assertThat(stage.platform().reviveCoordinator()).isTrue();
      stage.await("so is the mug", () -> stage.world().isNextTo("Mug", "Bob"));
      assertThat(stage.world().isNextTo("Cup", "Bob")).isTrue();
    }
  }

  /** The room's manager makes no plans: it has Rose go round, as its script says. */
  @Test
  void aSmallManagerOfARoomAndThatOfTheHouseShareARobotByWhatTheirGoalsAreWorth()
      throws IOException {
    try (Stage stage = stage("room", ofTheGuide(), text("/scenes/bob-dark.ttl"))) {
      List<StoryEntry> story = listen(stage);
      stage.await(
          "Rose goes round", () -> stage.world().zone("rose").equals(Optional.of("zone-a")));
      Pursuit cup = stage.begin(new AskedGoal("(nextTo Cup Bob)").benefit("300"));
      assertThat(cup.await().reached()).as(told(story)).isTrue();

      assertThat(stage.world().isNextTo("Cup", "Bob")).isTrue();
      assertThat(story)
          .anyMatch(
              entry ->
                  entry.goalId().equals("room-1")
                      && entry.text().contains("Waits: the base of rose is held by G1"));
      Optional<String> zone = stage.world().zone("rose");
      stage.await("Rose goes round again", () -> !stage.world().zone("rose").equals(zone));
    }
  }

  private static String ofTheGuide() throws IOException {
    Matcher block =
        Pattern.compile("```room\\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("../../docs/guide-scripts.md")));
    assertThat(block.find()).isTrue();
    return "\n" + block.group(1);
  }

  private static Pursuit overtaking(Stage stage, List<StoryEntry> story) {
    awaitTelling(stage, story, "team-1", ": rose drives to zone-b");
    Pursuit mug = stage.begin(new AskedGoal("(nextTo Mug Bob)").priority(5));
    awaitTelling(stage, story, "team-1", "Stands back: G1 goes first with the arm of rose");
    return mug;
  }

  private static void awaitTelling(Stage stage, List<StoryEntry> story, String goal, String part) {
    stage.await(goal + " tells: " + part, () -> tells(story, goal, part));
  }

  private static boolean tells(List<StoryEntry> story, String goal, String part) {
    return story.stream()
        .anyMatch(entry -> entry.goalId().equals(goal) && entry.text().contains(part));
  }

  private static String told(List<StoryEntry> story) {
    return String.join(
        "\n", story.stream().map(e -> e.at() + " " + e.goalId() + " " + e.text()).toList());
  }

  private static List<StoryEntry> listen(Stage stage) {
    List<StoryEntry> story = new CopyOnWriteArrayList<>();
    stage.platform().onStory(story::add);
    return story;
  }

  private static Stage stage(String name) {
    String roseInRoomA = text("/scenes/bob-dark.ttl").replace("4.0 0.8 0", "1.2 0.8 0");
    return stage(name, MUG, roseInRoomA + WHERE_IT_IS);
  }

  private static Stage stage(String name, String managers, String scene) {
    Home home = new HomeLoader().load(text("/homes/bob.ttl") + managers, "bob.ttl");
    return Stage.stepped(
        SiteSettings.of(name, home)
            .scene(
                SceneLoader.load(
                    "the scene",
                    new ByteArrayInputStream(scene.getBytes(StandardCharsets.UTF_8)),
                    home))
            .build());
  }

  private static String text(String path) {
    try (InputStream stream = SeveralGoalManagersTest.class.getResourceAsStream(path)) {
      return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
