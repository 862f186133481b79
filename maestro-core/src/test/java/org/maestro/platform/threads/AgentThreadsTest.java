package org.maestro.platform.threads;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Generic agents run on virtual threads where Java has such that can wait, all others never. */
class AgentThreadsTest {
  private static final int FIRST_WITH_VIRTUAL = 24;

  @TempDir Path files;

  @AfterEach
  void chooseNothing() {
    System.clearProperty(AgentThreads.PROPERTY);
  }

  @Test
  void genericAgentsGetTheLightestThreadsOfThisJava() {
    AgentThreads best =
        Runtime.version().feature() >= FIRST_WITH_VIRTUAL
            ? AgentThreads.VIRTUAL
            : AgentThreads.PLATFORM;
    assertThat(ThreadProbe.kinds(files))
        .isEqualTo("300 generic agents " + best + ", desk PLATFORM");
  }

  @Test
  void genericAgentsAreVirtualOnANewerJava() throws Exception {
    Optional<Path> newer = OtherJava.atLeast(FIRST_WITH_VIRTUAL);
    assumeTrue(
        newer.isPresent(),
        "Nothing is shown of virtual threads: no Java "
            + FIRST_WITH_VIRTUAL
            + " or newer stands beside this one (JAVA_OTHER_HOME may name one).");
    Path said = files.resolve("said.txt");
    Process process =
        new ProcessBuilder(
                List.of(
                    newer.get().toString(),
                    "-XX:TieredStopAtLevel=1",
                    "-XX:+UseSerialGC",
                    "-cp",
                    System.getProperty("java.class.path"),
                    ThreadProbe.class.getName()))
            .redirectErrorStream(true)
            .redirectOutput(said.toFile())
            .start();
    try {
      assertThat(process.waitFor(60, TimeUnit.SECONDS)).as("it ends").isTrue();
      assertThat(Files.readString(said)).contains("300 generic agents VIRTUAL, desk PLATFORM");
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void theSystemsThreadsCanBeAskedForEverywhere() {
    System.setProperty(AgentThreads.PROPERTY, "platform");
    assertThat(AgentThreads.chosen()).isEqualTo(AgentThreads.PLATFORM);
  }

  @Test
  void threadsThatAreNotThereAreToldInASentence() {
    System.setProperty(AgentThreads.PROPERTY, "green");
    assertThatThrownBy(AgentThreads::chosen)
        .hasMessage("There are no threads called green; -Dmaestro.threads is platform or virtual.");
    System.setProperty(AgentThreads.PROPERTY, "virtual");
    if (Runtime.version().feature() < FIRST_WITH_VIRTUAL) {
      assertThatThrownBy(AgentThreads::chosen).hasMessageContaining("take 24 or newer");
    } else {
      assertThat(AgentThreads.chosen()).isEqualTo(AgentThreads.VIRTUAL);
    }
  }
}
