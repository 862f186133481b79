package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.questions.AclQuestions;
import org.maestro.coordination.api.Speech;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/** Scripts speak to people by the desk, and to agents by their names, over the agents' messages. */
class SpokenTest {
  private static final Path ASSEMBLED = Path.of("../assembly/src/main/resources");

  private static final String SCRIPTS =
      """

      home:dawn a maestro:Script ;
        maestro:body \"""(seq
          (try (tell gardener (ping)) (recover "no such agent" (say Bob "There is no gardener.")))
          (try (tell CCA (ping)) (recover "operator ping" (say Bob "It does not know that.")))
          (tell CCA (query-ref waits))
          (try (tell CCA (inform (:goal other-1) (:state achieved)))
            (recover "does not speak for it" (say Bob "It is not believed."))))\""" .
      """;

  private static Stage stage(String name) throws IOException {
    String bob = Files.readString(ASSEMBLED.resolve("homes/bob.ttl"));
    Home home = new HomeLoader().load(bob + SCRIPTS + ofTheGuide(), "bob.ttl");
    return Stage.stepped(
        SiteSettings.of("spoken-" + name, home)
            .scene(
                SceneLoader.load(
                    "bob-dark",
                    new ByteArrayInputStream(
                        Files.readString(ASSEMBLED.resolve("scenes/bob-dark.ttl"))
                            .getBytes(StandardCharsets.UTF_8)),
                    home))
            .build());
  }

  private static String ofTheGuide() throws IOException {
    Matcher section =
        Pattern.compile("## People and agents\n\n```turtle\n(.*?)```", Pattern.DOTALL)
            .matcher(Files.readString(Path.of("../../docs/guide-scripts.md")));
    assertThat(section.find()).isTrue();
    return section.group(1);
  }

  private static List<Speech> heard(Stage stage) {
    List<Speech> heard = new CopyOnWriteArrayList<>();
    stage.platform().desk().whenSaid(heard::add);
    return heard;
  }

  @Test
  void whatIsSaidIsHeardAndWhoIsToldAGoalPursuesIt() throws IOException {
    try (Stage stage = stage("dusk")) {
      List<Speech> heard = heard(stage);

      MaestroAssertions.assertThat(stage.goal("(dusk Bob)"))
          .isReached()
          .tells("To Bob: \"Good evening, Bob.\"")
          .tells("The agent CCA is told (initCNP (:goal (>= (illuminance zone-b) 72))).");

      assertThat(heard)
          .containsExactly(
              new Speech("G1.1", "Bob", "Good evening, Bob."),
              new Speech("G1.4", "room-b", "It is light."));
      assertThat(stage.world().lux("zone-b")).isGreaterThanOrEqualTo(72);
    }
  }

  @Test
  void anAgentThatIsNotThereOrDoesNotUnderstandIsAReason() throws IOException {
    try (Stage stage = stage("dawn")) {
      List<Speech> heard = heard(stage);

      MaestroAssertions.assertThat(stage.goal("(dawn)"))
          .isReached()
          .tells("gardener has not taken it: there is no such agent; ./maestro agents lists")
          .tells("CCA has not taken it: The CCA does not know the operator ping;")
          .tells("CCA has not taken it: No agent of this platform stands for other, and CCA does");

      assertThat(heard)
          .extracting(Speech::text)
          .containsExactly(
              "There is no gardener.", "It does not know that.", "It is not believed.");
    }
  }

  /** As the guide has it: both answers, each by the desk. */
  @Test
  void whatIsAnsweredIsGoneBy() throws IOException {
    try (Stage stage = stage("offer")) {
      AclQuestions questions = new AclQuestions(stage.platform().desk());
      Pursuit unwanted = stage.begin("(offer Cup Bob)").awaitTelling("Asks Bob: \"Shall I bring");
      CompletableFuture<Void> no = questions.answer("G1.2", "no");
      MaestroAssertions.assertThat(unwanted.await())
          .isReached()
          .tells("[1] Seen: (in Cup zone-b).")
          .tells("[2] ?wanted is false, as desk has answered.")
          .tells("To Bob: \"Then it stays where it is.\"");
      assertThat(no).isCompleted();

      Pursuit wanted = stage.begin("(offer Cup Bob)").awaitTelling("Asks Bob: \"Shall I bring");
      CompletableFuture<Void> wrong = questions.answer("G2.2", "perhaps");
      stage.await("a refusal", wrong::isDone);
      assertThat(wrong)
          .failsWithin(Duration.ZERO)
          .withThrowableThat()
          .withMessageContaining("G2.2 is not answered by \"perhaps\"; write one of yes, no.");
      CompletableFuture<Void> yes = questions.answer("G2.2", "yes");
      MaestroAssertions.assertThat(wanted.await()).isReached().tells("Shows that it is glad");
      assertThat(yes).isCompleted();
      MaestroAssertions.assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }
  }
}
