package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/** What a child and a parent say to the house in which they live (ADE, 5; A11, A85). */
@Isolated("its time is wall time, which others beside it would take")
class FamilyPlatformTest {
  private static final Duration LIMIT = Duration.ofSeconds(120);

  @TempDir private Path directory;

  @Test
  @Tag("full")
  void aChildIsToldHowFarItMayGoAndAParentIsObeyed() throws Exception {
    try (JavaProcess platform =
        maestro(List.of("run", "evening", "--port", "0", "--speed", "20", "--console", "0"))) {
      Awaitility.await()
          .atMost(LIMIT)
          .until(
              () ->
                  platform.output().contains("The console, for a browser") || !platform.isAlive());

      assertThat(said(ExitCode.NOT_REACHED, "set the volume of the stereo to 80", "Tom"))
          .isEqualTo(
              """
              You asked me to see to it that the volume of the stereo is 80, just now.
              Tom, you may set the volume of the stereo to 60 at most; Dave, Grandma or Rose may set\
               it higher.""");
      assertThat(command(ExitCode.DONE, "know", "(= (volume stereo) ?v)")).contains("?v = 50");
      assertThat(command(ExitCode.DONE, "why", "G1"))
          .contains("desk for Tom asks for")
          .contains("stated by volume-of-children in evening.ttl");
      assertThat(said(ExitCode.DONE, "set the volume of the stereo to 80", "Dave"))
          .contains("The volume of the stereo is 80.");
      assertThat(command(ExitCode.DONE, "know", "(= (volume stereo) ?v)")).contains("?v = 80");

      assertThat(command(ExitCode.NOT_REACHED, "goal", "(switchedOn oven)", "--as", "Mia"))
          .contains("For Mia it may not be that the oven is switched on");
    }
  }

  private String said(int exitCode, String words, String person) throws Exception {
    return command(exitCode, "say", words, "--as", person, "--in", "livingroom");
  }

  private String command(int exitCode, String... arguments) throws Exception {
    try (JavaProcess process = maestro(List.of(arguments))) {
      JavaProcess.Ended ended = process.await(LIMIT);
      assertThat(ended.exitCode()).as(ended.output() + ended.errors()).isEqualTo(exitCode);
      return ended.output().strip();
    }
  }

  private JavaProcess maestro(List<String> arguments) throws IOException {
    return JavaProcess.start(
        Maestro.class.getName(), arguments, Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }
}
