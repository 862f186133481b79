package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.maestro.junit.MaestroAssertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import jade.lang.acl.ACLMessage;
import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.UUID;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.agents.content.Words;
import org.maestro.assembly.SiteSettings;
import org.maestro.console.questions.AclQuestions;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.sim.scene.SceneLoader;

/** Rules of the home's file: held from the start on, listed, cancelled, and never doubled. */
class HomeRulesTest {
  private static final String RULE =
      """

      home:pairOfLamps a maestro:Rule ; rdfs:label "the lamps are a pair" ;
        maestro:pursues "(whenever (= (level lamp-a1) 0.5) (= (level lamp-b1) 0.25))" .
      """;
  private static final String SO_ALREADY = "0.5";
  private static final Duration UNTIL_THEY_ARE_HELD = Duration.ofSeconds(3);

  @TempDir Path data;

  private Stage stage(String lampA1) {
    Home home = new HomeLoader().load(EveningStage.text("/homes/bob.ttl") + RULE, "bob.ttl");
    String turtle =
        EveningStage.text("/scenes/bob-dark.ttl")
            .replaceAll(
                "<#lamp-a1> scene:level [0-9.]+ .", "<#lamp-a1> scene:level " + lampA1 + " .");
    Stage stage =
        Stage.stepped(
            SiteSettings.of("rules-" + UUID.randomUUID(), home)
                .scene(
                    SceneLoader.load(
                        "bob-dark",
                        new ByteArrayInputStream(turtle.getBytes(StandardCharsets.UTF_8)),
                        home))
                .dataDirectory(data)
                .build());
    stage.run(UNTIL_THEY_ARE_HELD);
    return stage;
  }

  private static List<String> goals(Stage stage) {
    CompletableFuture<JsonNode> asked = new AclQuestions(stage.platform().desk()).goals();
    stage.await("the goals are told", asked::isDone);
    List<String> goals = new ArrayList<>();
    asked
        .join()
        .path("goals")
        .forEach(goal -> goals.add(goal.path("id").asText() + " " + goal.path("state").asText()));
    return goals;
  }

  private static void isAPair(Stage stage, boolean isOne) {
    assertThat(stage.goal("(= (level lamp-b1) 1)")).isReached();
    assertThat(stage.goal("(= (level lamp-a1) 1)")).isReached();
    assertThat(stage.goal("(= (level lamp-a1) 0.5)")).isReached();
    stage.run(Duration.ofSeconds(5));
    assertThat(stage.world().lampLevel("lamp-b1")).isEqualTo(isOne ? 0.25 : 1);
  }

  @Test
  void aRuleIsHeldFromTheStartOnAndWhatItBeginsIsAnOrdinaryGoal() {
    try (Stage stage = stage("1")) {
      List<String> told = new CopyOnWriteArrayList<>();
      stage.platform().onStory(entry -> told.add(entry.goalId() + " " + entry.text()));
      assertThat(goals(stage)).containsExactly("pairOfLamps waiting");

      isAPair(stage, true);

      assertThat(goals(stage)).contains("pairOfLamps waiting", "G1 achieved", "G4 achieved");
      assertThat(told)
          .anyMatch(line -> line.startsWith("pairOfLamps Begins G4, because"))
          .anyMatch(line -> line.startsWith("G4 Begun by pairOfLamps, because"));
    }
  }

  @Test
  void whatIsSoAtTheStartDoesNotCount() {
    try (Stage stage = stage(SO_ALREADY)) {
      stage.run(Duration.ofSeconds(15));
      assertThat(stage.world().lampLevel("lamp-b1")).isZero();
      assertThat(goals(stage)).containsExactly("pairOfLamps waiting");
    }
  }

  @Test
  void aRuleIsCancelledByItsNameUntilThePlatformBeginsAgain() {
    try (Stage stage = stage("1")) {
      List<Integer> answers = new CopyOnWriteArrayList<>();
      stage
          .platform()
          .desk()
          .request(
              ACLMessage.REQUEST,
              "CCA",
              Duration.ofSeconds(30),
              reply -> answers.add(reply.getPerformative()),
              Words.content("cancel", Words.named("goal", Words.name("pairOfLamps"))));
      stage.await("it is cancelled", () -> !answers.isEmpty());

      assertThat(answers).containsExactly(ACLMessage.INFORM);
      isAPair(stage, false);
      assertThat(goals(stage)).contains("pairOfLamps cancelled");
    }
    try (Stage stage = stage("1")) {
      isAPair(stage, true);
    }
  }

  @Test
  void afterARestartThereIsOneAndItBeginsOneGoal() {
    try (Stage stage = stage("1")) {
      isAPair(stage, true);
    }
    try (Stage stage = stage(SO_ALREADY)) {
      assertThat(goals(stage)).filteredOn(goal -> goal.endsWith(" waiting")).hasSize(1);
      stage.run(Duration.ofSeconds(15));
      assertThat(stage.world().lampLevel("lamp-b1")).as("it was so before").isZero();

      List<String> before = goals(stage);
      isAPair(stage, true);
      assertThat(goals(stage)).hasSize(before.size() + 4);
    }
  }
}
