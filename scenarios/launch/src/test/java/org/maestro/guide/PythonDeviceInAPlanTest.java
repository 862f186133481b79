package org.maestro.guide;

import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** The example of a device in Python serves a goal that nobody else could. */
class PythonDeviceInAPlanTest {

  private static final String SITE = "teahouse";

  @Test
  void aFeatureThatMaestroHasNeverSeenIsUsedInAPlan() throws IOException, InterruptedException {
    assumeTrue(hasPython(), "python3 with paho-mqtt is not installed; .ci/run installs them");
    try (Stage stage = Stage.paced(SiteSettings.of(SITE, home("tea.ttl")).build())) {
      MaestroAssertions.assertThat(stage.goal("(served Tea Anna)")).isNotReached();
      Process kettle = start("docs/examples/kettle.py", stage.broker());
      try {
        stage.await("the kettle", () -> stage.platform().presentMembers().contains("kettle-1"));
        GoalOutcome outcome = stage.goal("(and (served Tea Anna) (served Tea Ben))");
        MaestroAssertions.assertThat(outcome)
            .isReached()
            .tells("brews Tea for Anna")
            .tells("brews Tea for Ben")
            .hasCalls(2);
      } finally {
        kettle.destroyForcibly();
      }
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"docs/examples/kettle.py", "rats-bridge/python/examples/kettle.py"})
  void itBringsItsOwnWordsToAHomeThatHasNoneForThem(String script)
      throws IOException, InterruptedException {
    assumeTrue(hasPython(), "python3 with paho-mqtt is not installed; .ci/run installs them");
    Home bob = home("bob.ttl");
    try (Stage stage = Stage.paced(SiteSettings.of(SITE, bob).build())) {
      Process kettle = start(script, stage.broker());
      try {
        stage.await("the kettle", () -> stage.platform().presentMembers().contains("kettle-1"));
        MaestroAssertions.assertThat(stage.goal("(served tea Bob)"))
            .isReached()
            .tells("kettle-1 brews tea for Bob")
            .hasCalls(1);
        MaestroAssertions.assertThat(stage.knowledge()).knows("(served tea Bob)");
      } finally {
        kettle.destroyForcibly();
      }
    }
  }

  private static Process start(String script, URI broker) throws IOException {
    Path project = Path.of("..", "..");
    ProcessBuilder builder =
        new ProcessBuilder(
                List.of(
                    "python3",
                    project.resolve(script).toString(),
                    broker.getHost(),
                    String.valueOf(broker.getPort()),
                    SITE))
            .inheritIO();
    builder.environment().put("PYTHONPATH", project.resolve("rats-bridge/python/src").toString());
    builder.environment().put("PYTHONDONTWRITEBYTECODE", "1");
    return builder.start();
  }

  private static Home home(String file) throws IOException {
    try (InputStream text = PythonDeviceInAPlanTest.class.getResourceAsStream("/homes/" + file)) {
      return new HomeLoader().load(new String(text.readAllBytes(), StandardCharsets.UTF_8), file);
    }
  }

  static boolean hasPython() throws InterruptedException {
    try {
      return new ProcessBuilder("python3", "-c", "import paho.mqtt.enums").start().waitFor() == 0;
    } catch (IOException none) {
      return false;
    }
  }
}
