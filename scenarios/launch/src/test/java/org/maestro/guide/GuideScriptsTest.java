package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.content.AskedGoal;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.launch.Printed;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;
import org.maestro.sl.PrintedScript;
import org.maestro.sl.PrintedScriptReader;
import org.maestro.sl.SlParser;

/** The scripts of the guide are listed as it shows, and do what it says. */
class GuideScriptsTest {
  private static final Path GUIDE = Path.of("../../docs/guide-scripts.md");
  private static final Path ASSEMBLED = Path.of("../assembly/src/main/resources");

  @TempDir private Path directory;

  private static String block(String language) throws IOException {
    Matcher block =
        Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(GUIDE));
    assertThat(block.find()).isTrue();
    return block.group(1);
  }

  private static String turtle() throws IOException {
    return Files.readString(ASSEMBLED.resolve("homes/bob.ttl")) + "\n" + block("turtle");
  }

  private static Stage stage(String name) throws IOException {
    return stage(name, turtle());
  }

  private static Stage stage(String name, String turtle) throws IOException {
    Home home = new HomeLoader().load(turtle, "bob.ttl");
    return Stage.stepped(
        SiteSettings.of("scripts-" + name, home)
            .scene(
                SceneLoader.load(
                    "bob-dark",
                    new ByteArrayInputStream(
                        Files.readString(ASSEMBLED.resolve("scenes/bob-dark.ttl"))
                            .getBytes(StandardCharsets.UTF_8)),
                    home))
            .build());
  }

  @Test
  void scriptsAreListedWithWhatTheyTakeAndAreWorth() throws IOException {
    Path home = Files.writeString(directory.resolve("bob.ttl"), turtle());

    assertThat(Printed.by("scripts", home.toString())).isEqualTo(block("text"));
    assertThat(Printed.by("scripts", "arena")).startsWith("This home has no scripts");
    assertThat(Printed.by("scripts", home.toString(), "--json")).contains("\"kind\":\"script\"");
  }

  /** The lines of the paper, the script of the shipped home, and the body that they mean. */
  @Test
  void thePapersScriptIsInTheShippedHomeAndIsThatBody() throws IOException {
    Home home = new HomeLoader().load(ASSEMBLED.resolve("homes/livingroom.ttl"));
    PrintedScript printed =
        PrintedScriptReader.read(block("printed"), home.scripts().keySet()::contains);

    assertThat(printed.body())
        .isEqualTo(SlParser.body(block("body"), home.vocabulary()::isFluent))
        .isEqualTo(home.scripts().get(printed.name()).body());
  }

  @Test
  void theHabitIsThatOfTheShippedHome() throws IOException {
    assertThat(Files.readString(ASSEMBLED.resolve("homes/livingroom.ttl")))
        .contains(block("habit").strip());
  }

  @Test
  void theTestOfTheHousekeeperIsTheOneThatIsRun() throws IOException {
    assertThat(Files.readString(Path.of("src/test/java/org/maestro/scenario/HousekeeperTest.java")))
        .contains(block("java"));
  }

  /** Each of the section is taken on, by a message of an agent, and listed with what it awaits. */
  @Test
  void timesAndEventsAreAsTheGuideSays() throws IOException {
    String guide = Files.readString(GUIDE);
    List<String> goals =
        Pattern.compile("^\\./maestro goal '(.*?)'", Pattern.MULTILINE)
            .matcher(guide.substring(guide.indexOf("## Times and events")))
            .results()
            .map(command -> command.group(1))
            .toList();
    assertThat(goals).hasSize(9);
    try (Stage stage = stage("times")) {
      List<Pursuit> begun =
          goals.stream().filter(goal -> !goal.startsWith("(until")).map(stage::begin).toList();
      GoalOutcome outcome = stage.goal("(after 5 (goodNight))");

      MaestroAssertions.assertThat(outcome).isReached();
      MaestroAssertions.assertThat(stage.world()).hasLampAt("lamp-a1", 0).hasLampAt("lamp-a2", 0);
      assertThat(begun).hasSize(8);
    }
  }

  @Test
  void theRulesAreHeldFromTheStartOn() throws IOException {
    String text = turtle() + "\n" + block("rule");
    assertThat(new HomeLoader().load(text, "bob.ttl").rules())
        .containsOnlyKeys("everyEvening", "porchLight");
    try (Stage stage = stage("rules", text)) {
      List<String> told = new CopyOnWriteArrayList<>();
      stage.platform().onStory(entry -> told.add(entry.goalId() + " " + entry.text()));
      stage.await(
          "they are held",
          () ->
              told.stream().anyMatch(line -> line.startsWith("everyEvening the home asks for"))
                  && told.stream().anyMatch(line -> line.startsWith("porchLight the home asks")));
    }
  }

  @Test
  void goodNightTurnsEverythingOff() throws IOException {
    try (Stage stage = stage("night")) {
      GoalOutcome outcome = stage.goal("(goodNight)");

      MaestroAssertions.assertThat(outcome).isReached();
      MaestroAssertions.assertThat(stage.world()).hasLampAt("lamp-a1", 0).hasLampAt("lamp-a2", 0);
    }
  }

  @Test
  void whoBringsSomethingComesBackWhateverBecomesOfIt() throws IOException {
    try (Stage stage = stage("bring")) {
      MaestroAssertions.assertThat(stage.goal("(bring Cup Bob)"))
          .isReached()
          .tells("Worth: u = 0.8·60")
          .tells("[1.2");
      MaestroAssertions.assertThat(stage.world()).hasNextTo("Cup", "Bob");
      MaestroAssertions.assertThat(stage.knowledge()).knows("(in rose zone-b)");

      Pursuit given = stage.begin(new AskedGoal("(bring Cup Bob)"));
      given.await();
      MaestroAssertions.assertThat(stage.knowledge()).knows("(in rose zone-b)");
    }
  }

  @Test
  void aScriptIsAStepOfThePlanThatNeedsIt() throws IOException {
    String text = turtle() + "\n" + block("composite");
    try (Stage stage = stage("composite", text)) {
      GoalOutcome outcome = stage.goal("(and (ready zone-b) (nextTo Cup Bob))");

      MaestroAssertions.assertThat(outcome)
          .isReached()
          .tells("the script prepare is run for zone-b")
          .tells("[1.1");
      MaestroAssertions.assertThat(stage.world()).hasNextTo("Cup", "Bob");
      assertThat(stage.world().lux("zone-b")).isGreaterThanOrEqualTo(72);
    }
  }

  @Test
  void whatCannotBeAsBrightAsWishedIsAsBrightAsItGets() throws IOException {
    try (Stage stage = stage("bright")) {
      MaestroAssertions.assertThat(stage.goal("(brighten zone-b 100000)"))
          .isReached()
          .tells("Recovers from this");
      MaestroAssertions.assertThat(stage.world())
          .hasLampAt("lamp-b1", 1)
          .hasLampAt("lamp-b2", 1)
          .hasLampAt("lamp-b3", 1);
    }
  }
}
