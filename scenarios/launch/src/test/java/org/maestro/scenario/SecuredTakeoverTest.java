package org.maestro.scenario;

import static org.junit.jupiter.api.Assumptions.assumeTrue;
import static org.maestro.junit.MaestroAssertions.assertThat;

import java.io.File;
import java.io.IOException;
import java.io.InputStream;
import java.net.ServerSocket;
import java.net.Socket;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.maestro.assembly.SiteSettings;
import org.maestro.hal.Position;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.Pursuit;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;
import org.maestro.rats.security.SecureSite;
import org.maestro.rats.security.SiteSecurity;
import org.maestro.sim.scene.SceneLoader;

/**
 * A takeover (Three-layered architecture, 3.2.1; M43) in a whole run on a secured site: TLS,
 * passwords, the access lists and rules as {@code ./maestro secure} writes them, with nothing
 * added.
 */
@Tag("full")
@Isolated("its time is wall time, which others beside it would take")
class SecuredTakeoverTest {

  private static final String NAME = "three-rooms-two-robots";
  private static final String USUAL_LISTENER = "listener 8883";

  @TempDir Path files;

  @Test
  void onArtemis() throws IOException {
    assertTakeover(Optional.empty());
  }

  @Test
  void onMosquitto() throws Exception {
    assumeTrue(Files.isExecutable(mosquitto()), "mosquitto is not installed; .ci/run installs it");
    Home home = home();
    secure(home);
    int port = freePort();
    Process broker = startMosquitto(port);
    try {
      Awaitility.await().until(() -> accepts(port));
      assertTakeover(Optional.of(URI.create("ssl://127.0.0.1:" + port)));
    } finally {
      broker.destroyForcibly().waitFor();
    }
  }

  private void assertTakeover(Optional<URI> broker) throws IOException {
    Home home = home();
    secure(home);
    SiteSettings settings =
        SiteSettings.of(NAME, home)
            .scene(SceneLoader.load("the scene", resource("three-rooms-robots-in-a.ttl"), home))
            .broker(broker)
            .security(SiteSecurity.open(files))
            .build();
    try (Stage stage = Stage.paced(settings)) {
      stage.world().moveByHand("Bob", new Position(7.2, 2.2, 0));
      Pursuit pursuit = stage.begin("(nextTo Cup Bob)").awaitTelling(": rose drives to zone-c");
      stage.world().moveByHand("tim", new Position(7.2, 0.6, 0));

      GoalOutcome outcome = pursuit.await();

      assertThat(outcome)
          .isReached()
          .tells("tim offers to do for 0.5 what is left of step")
          .tells("No longer wanted: rose drives to zone-c")
          .tells("tim picks up Cup")
          .neverTells("rose reports: Cup is in rose");
      assertThat(stage.world()).hasNextTo("Cup", "Bob");
    }
  }

  private void secure(Home home) {
    SecureSite.make(
        files,
        NAME,
        List.of("localhost", "127.0.0.1"),
        List.of("maestro"),
        home.devices().keySet());
  }

  private Process startMosquitto(int port) throws IOException {
    Path shipped = files.resolve("mosquitto/mosquitto.conf");
    String[] listeners = Files.readString(shipped).split("(?=listener )");
    String byPassword = listeners[1].replace(USUAL_LISTENER, "listener " + port + " 127.0.0.1");
    Path here = files.resolve("mosquitto/here.conf");
    Files.writeString(here, listeners[0] + byPassword);
    return new ProcessBuilder(mosquitto().toString(), "-c", here.toString())
        .redirectErrorStream(true)
        .redirectOutput(files.resolve("mosquitto/output").toFile())
        .start();
  }

  private static Path mosquitto() {
    return Stream.of((System.getenv("PATH") + ":/usr/sbin").split(File.pathSeparator))
        .map(folder -> Path.of(folder, "mosquitto"))
        .filter(Files::isExecutable)
        .findFirst()
        .orElse(Path.of("mosquitto"));
  }

  private static boolean accepts(int port) {
    try (Socket probe = new Socket("127.0.0.1", port)) {
      return probe.isConnected();
    } catch (IOException notYet) {
      return false;
    }
  }

  private static int freePort() throws IOException {
    try (ServerSocket probe = new ServerSocket(0)) {
      return probe.getLocalPort();
    }
  }

  private static Home home() throws IOException {
    try (InputStream text = resource("three-rooms-two-robots.ttl")) {
      return new HomeLoader()
          .load(new String(text.readAllBytes(), StandardCharsets.UTF_8), "the home");
    }
  }

  private static InputStream resource(String name) {
    return SecuredTakeoverTest.class.getResourceAsStream("/" + name);
  }
}
