package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import jade.lang.acl.ACLMessage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.maestro.agents.content.AgentNames;
import org.maestro.agents.content.Words;
import org.maestro.platform.JoinedContainer;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.broker.EmbeddedBroker;
import org.maestro.rats.time.PacedClock;

/**
 * The platform's process is stopped by the system while the robot picks up the cup, and goes on
 * later, as if it had been asleep. Devices and broker live on in other processes.
 */
@Isolated("its time is wall time, which others beside it would take")
@Tag("full")
class FrozenMainTest {
  private static final Duration LIMIT = Duration.ofSeconds(180);
  private static final int PICK_MILLIS = 6_000;

  /** All of Bob's home. */
  private static final int DEVICES = 10;

  @TempDir Path directory;

  @ParameterizedTest(name = "seed {0}")
  @ValueSource(longs = {1, 2, 3})
  void theCupComesThoughThePlatformSleptWhileItWasPickedUp(long seed) throws Exception {
    Random random = new Random(seed);
    Duration at = Duration.ofMillis(random.nextInt(PICK_MILLIS));
    Duration lasting = Duration.ofMillis(1_000 + random.nextInt(29_000));
    try (PacedClock clock = new PacedClock(1);
        EmbeddedBroker broker = EmbeddedBroker.start();
        JavaProcess main =
            maestro("run", "bob", "--no-sim", "--port", "0", "--broker", broker.uri().toString())) {
      until(() -> main.output().contains("runs: "));
      String port = main.output().replaceAll("(?s).*JADE on port (\\d+).*", "$1");
      try (JavaProcess devices = maestro("devices", "bob", "--broker", broker.uri().toString())) {
        until(() -> readyAgents(Integer.parseInt(port), clock) == DEVICES);
        assertThat(devices.isAlive()).isTrue();
        bringsTheCup(port, main, clock, at, lasting);
      }
    }
  }

  private void bringsTheCup(
      String port, JavaProcess main, PacedClock clock, Duration at, Duration lasting)
      throws Exception {
    try (JavaProcess goal = maestro("goal", "(nextTo Cup Bob)", "--main", "127.0.0.1:" + port)) {
      until(() -> !goal.isAlive() || goal.output().contains(": rose picks up Cup."));
      pass(clock, at);
      main.freeze();
      pass(clock, lasting);
      main.thaw();
      assertThat(goal.await(LIMIT).exitCode())
          .as(() -> "frozen for %s:%n%s%n%s".formatted(lasting, goal.output(), main.output()))
          .isZero();
    }
  }

  private static long readyAgents(int port, PacedClock clock) {
    try (JoinedContainer desk =
        JoinedContainer.join(
            Optional.of("maestro"), "127.0.0.1", port, "desk-" + System.nanoTime(), clock)) {
      ACLMessage answer =
          desk.ask(ACLMessage.QUERY_REF, AgentNames.SUPERVISOR, Words.content("query-ref"));
      return Words.parse(answer.getContent()).stream()
          .map(Words::of)
          .filter(line -> line.string("phase").equals(Optional.of("ready")))
          .filter(line -> line.find("services").isPresent())
          .count();
    } catch (PlatformStartException e) {
      return 0;
    }
  }

  private static void pass(PacedClock clock, Duration time) throws InterruptedException {
    CountDownLatch over = new CountDownLatch(1);
    clock.schedule(time, "test", over::countDown);
    assertThat(over.await(LIMIT.toSeconds(), TimeUnit.SECONDS)).isTrue();
  }

  private static void until(BooleanSupplier condition) {
    Awaitility.await()
        .pollInterval(Duration.ofMillis(20))
        .atMost(LIMIT)
        .until(condition::getAsBoolean);
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    Path runtime = Files.createDirectories(directory.resolve("runtime"));
    return JavaProcess.startLogging(
        "org.maestro.launch.Maestro",
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", runtime.toString()));
  }
}
