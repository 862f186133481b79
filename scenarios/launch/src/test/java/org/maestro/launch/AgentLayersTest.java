package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;
import org.maestro.console.questions.AclQuestions;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;

/** What {@code ./maestro agents --layers} prints (Three-layered architecture, 3; M1). */
@MaestroTest(home = "bob", scene = "bob-dark")
class AgentLayersTest {

  @Test
  void anAgentIsShownWithItsMemberAndTheDriverBelow(Stage stage) {
    CompletableFuture<JsonNode> agents =
        new AclQuestions(stage.platform().desk(), container -> true).agents();
    stage.await("the agents are told", agents::isDone);

    List<List<String>> described =
        stage.knowledge().home().devices().values().stream()
            .map(
                device ->
                    List.of(
                        device.id(),
                        device.container().orElseThrow(),
                        device.id(),
                        "ready",
                        "standby",
                        device.driver().orElseThrow()))
            .toList();
    assertThat(AgentsCommand.layers(agents.join()))
        .containsExactlyInAnyOrderElementsOf(described)
        .contains(List.of("rose", "robots", "rose", "ready", "standby", "mobile-robot"));
  }
}
