package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.deployment.ContainerStart;
import org.maestro.junit.ClockKind;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.platform.AgentRow;
import org.maestro.platform.JoinedContainer;
import org.maestro.rats.time.PacedClock;

/** A process asks for a topic's agents, and is no more before it has begun them. */
@Isolated("its time is wall time, which others beside it would take")
@Tag("full")
@MaestroTest(home = "bob", scene = "bob-dark", clock = ClockKind.PACED, speed = 10)
class HandoverTest {
  private static final ContainerStart LIGHTS =
      new ContainerStart("lights", Set.of(), Set.of(), false, Optional.empty());

  @Test
  void agentsWhoseNewProcessDiesBeforeItJoinsHaveTheirPlaceAgain(Stage stage) {
    comeBackFrom(stage, false);
  }

  @Test
  void agentsWhoseNewProcessDiesBeforeItBeginsThemHaveTheirPlaceAgain(Stage stage) {
    comeBackFrom(stage, true);
  }

  private static void comeBackFrom(Stage stage, boolean joined) {
    List<String> lamps =
        stage.platform().agents().stream()
            .filter(row -> row.container().equals(LIGHTS.name()))
            .map(AgentRow::agent)
            .toList();
    stage.await("the lights are there", () -> stage.platform().presentMembers().containsAll(lamps));
    try (PacedClock clock = new PacedClock(1);
        JoinedContainer joining =
            JoinedContainer.join(
                Optional.of(stage.platform().desk().getHap()),
                "127.0.0.1",
                stage.platform().port(),
                "lights-hand-over",
                clock)) {
      joining.ask(LIGHTS);
      if (joined) {
        joining.ask(
            ACLMessage.REQUEST,
            AgentNames.SUPERVISOR,
            Words.content(
                "perform",
                Words.named("action", Words.name("joined")),
                Words.named("container", Words.text(LIGHTS.name()))));
      }
      assertThat(stage.platform().topics()).doesNotContain(LIGHTS.name());
    }
    stage.await("the lights are back", () -> areBack(stage, lamps));
    assertThat(stage.platform().agents()).extracting(AgentRow::agent).doesNotHaveDuplicates();
  }

  private static boolean areBack(Stage stage, List<String> lamps) {
    return stage.platform().topics().contains(LIGHTS.name())
        && stage.platform().presentMembers().containsAll(lamps)
        && lamps.stream().allMatch(lamp -> stage.platform().directory().find(lamp).isPresent());
  }
}
