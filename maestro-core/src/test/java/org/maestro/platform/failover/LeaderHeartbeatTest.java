package org.maestro.platform.failover;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.deployment.ProcessStart;

/** Who stands by ends a process that has the duty and is frozen, and no other (ADE, 3.2; A32). */
class LeaderHeartbeatTest {
  private static final Duration LOOK = Duration.ofMillis(50);

  @TempDir Path directory;

  private LeaderHeartbeat looking;
  private Process other;

  @BeforeEach
  void anotherHasTheDuty() throws IOException {
    looking = new LeaderHeartbeat(directory);
    other = new ProcessBuilder("sleep", "600").start();
    beats(1, ProcessStart.machineName());
  }

  @AfterEach
  void itEnds() {
    other.destroyForcibly();
  }

  private void beats(int number, String machine) throws IOException {
    Files.write(
        directory.resolve("duty-beat"),
        List.of(
            machine,
            String.valueOf(other.pid()),
            other.info().startInstant().map(Instant::toString).orElse(""),
            String.valueOf(number)));
  }

  private void look(Duration forSoLong) {
    for (long at = 0; at <= forSoLong.toMillis(); at += LOOK.toMillis()) {
      looking.look(LOOK);
    }
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void oneThatIsStoppedIsEndedAfterThreeSeconds() throws Exception {
    int sent = new ProcessBuilder("kill", "-STOP", String.valueOf(other.pid())).start().waitFor();
    assertThat(sent).isZero();
    Path status = Path.of("/proc", String.valueOf(other.pid()), "status");
    await()
        .atMost(Duration.ofSeconds(30))
        .until(() -> Files.readString(status).contains("State:\tT"));
    look(LeaderHeartbeat.FROZEN_AFTER.minus(LOOK.multipliedBy(4)));
    assertThat(other.isAlive()).isTrue();

    look(LOOK.multipliedBy(6));

    await().atMost(Duration.ofSeconds(30)).until(() -> !other.isAlive());
  }

  @Test
  void oneThatIsOnlyShortOfTimeGetsMore() {
    look(LeaderHeartbeat.HUNG_AFTER.minus(LOOK.multipliedBy(4)));
    assertThat(other.isAlive()).isTrue();

    look(LOOK.multipliedBy(6));

    await().atMost(Duration.ofSeconds(30)).until(() -> !other.isAlive());
  }

  @Test
  void oneThatBeatsIsLeftAlone() throws IOException {
    for (int number = 2; number < 30; number++) {
      look(Duration.ofSeconds(2));
      beats(number, ProcessStart.machineName());
    }
    assertThat(other.isAlive()).isTrue();
  }

  @Test
  void whoHasSleptItselfBlamesNobody() {
    looking.look(LOOK);
    looking.look(Duration.ofHours(1));
    assertThat(other.isAlive()).isTrue();
  }

  @Test
  void aProcessOfAnotherMachineIsNotTouched() throws IOException {
    beats(2, "another-machine");
    look(Duration.ofSeconds(60));
    assertThat(other.isAlive()).isTrue();
  }

  @Test
  void whoHasTheDutyBeats() {
    try (LeaderLock duty = LeaderLock.tryToTake(directory).orElseThrow()) {
      await()
          .atMost(Duration.ofSeconds(30))
          .until(
              () -> {
                List<String> lines = Files.readAllLines(directory.resolve("duty-beat"));
                return lines.size() == 4
                    && lines.get(1).equals(String.valueOf(ProcessHandle.current().pid()));
              });
      assertThat(duty).isNotNull();
    }
  }
}
