package org.maestro.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.junit.ClockKind;
import org.maestro.junit.MaestroTest;
import org.maestro.junit.Stage;
import org.maestro.launch.JavaProcess;
import org.maestro.platform.AgentRow;

/**
 * A topic's agents live in another process (Three-layered architecture, 3.3.1 and 3.3.2; M64, M70).
 */
@Isolated("its time is wall time, which others beside it would take")
@MaestroTest(home = "bob", scene = "bob-dark", clock = ClockKind.PACED, speed = 10)
class RemoteContainerTest {

  private static final String LAMP = "lamp-b1";

  @Test
  void theLightsOfBobsCupMayLiveInAnotherProcessAndComeBackWhenItIsKilled(
      Stage stage, @TempDir Path directory) throws Exception {
    List<String> lamps =
        stage.platform().agents().stream()
            .filter(row -> row.container().equals("lights"))
            .map(AgentRow::agent)
            .toList();
    assertThat(lamps).contains(LAMP);
    Optional<String> platform = Optional.of(stage.platform().desk().getHap());
    try (PlainAgent.Guest guest =
        PlainAgent.join(platform, stage.platform().port(), "guests", "Guest")) {
      try (JavaProcess process = lights(stage, directory)) {
        stage.await(
            "the other process has the lights",
            () -> process.output().contains("The container lights runs here"));
        stage.await(
            "the lights are back", () -> stage.platform().presentMembers().containsAll(lamps));

        assertThat(guest.agent().whereIs(LAMP)).as("the topic's name").contains(":name lights ");
        assertThat(lightsHere(stage)).as("they are elsewhere").isFalse();
        assertThat(stage.platform().agents()).extracting(AgentRow::agent).containsAll(lamps);
        assertThat(stage.goal("(nextTo Cup Bob)")).isReached().tells("is set to");
        assertThat(stage.world()).hasNextTo("Cup", "Bob").hasLuxAtLeast("zone-b", 72);
        try (JavaProcess second = lights(stage, directory)) {
          assertThat(second.await(Duration.ofSeconds(30)).errors())
              .isEqualToIgnoringNewLines(
                  "maestro: The platform has a container lights already; choose another --name.");
        }
      }
      await().atMost(Duration.ofSeconds(30)).until(() -> lightsHere(stage));
      stage.await(
          "all lights are back here", () -> stage.platform().presentMembers().containsAll(lamps));
    }
  }

  /** Whether this process, as its supervisor says, has a container of that topic. */
  private static boolean lightsHere(Stage stage) {
    return stage.platform().topics().contains("lights");
  }

  private static JavaProcess lights(Stage stage, Path directory) throws Exception {
    return JavaProcess.start(
        "org.maestro.launch.Maestro",
        List.of("container", "--main", "127.0.0.1:" + stage.platform().port(), "--name", "lights"),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }
}
