package org.maestro.platform.jade;

import static org.assertj.core.api.Assertions.assertThat;

import jade.wrapper.AgentContainer;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.platform.jade.JadeRuntime.Entry;

/**
 * A container that joins as soon as the port of the main one answers, which is before its system
 * agents are there: so come clients of a platform whose process has died, when another takes over.
 */
class EarlyJoinTest {
  private static final String NAME = "early-join";

  /** The main container is begun without the just-in-time compiler, so that it takes its time. */
  @Test
  void whoComesBeforeTheMainContainerIsReadyWaitsForIt(@TempDir Path files) throws Exception {
    int port = Sockets.claim(0);
    Path said = files.resolve("said.txt");
    Process late =
        new ProcessBuilder(
                List.of(
                    Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                    "-Xint",
                    "-cp",
                    System.getProperty("java.class.path"),
                    LateMain.class.getName(),
                    NAME,
                    String.valueOf(port),
                    files.toString()))
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start();
    try {
      Awaitility.await()
          .pollDelay(Duration.ZERO)
          .pollInterval(Duration.ofMillis(1))
          .atMost(Duration.ofSeconds(60))
          .until(() -> Sockets.addressTowards(Premises.LOOPBACK, port).isPresent());
      AgentContainer joined =
          JadeRuntime.join(Optional.of(NAME), Premises.LOOPBACK, port, "early", files, Entry.OPEN);
      assertThat(joined.isJoined()).isTrue();
      ContainerEnds.endNow(joined);
      Awaitility.await().until(() -> Files.readString(said).contains("begun"));
    } finally {
      late.destroyForcibly().waitFor();
    }
  }
}
