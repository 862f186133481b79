package org.maestro.guide;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.net.URI;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.assembly.SiteSettings;
import org.maestro.junit.GoalOutcome;
import org.maestro.junit.MaestroAssertions;
import org.maestro.junit.Stage;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.HomeLoader;

/** Devices of strangers, in a language and a process of their own, that answer in odd ways. */
class OddDevicesTest {
  private static final String SITE = "odd";

  @TempDir private Path directory;

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      textBlock =
          """
          text|kilograms has to be a number, and is "heavy"
          nan|kilograms has to be a number, and is "NaN"
          null|kilograms is missing
          missing|kilograms is missing
          """)
  void whoTellsRubbishIsCalledThreeTimes(String way, String named) throws Exception {
    try (Stage stage = stage();
        Odd odd = new Odd(stage.broker(), way)) {
      stage.await("the odd one", () -> stage.platform().presentMembers().contains("odd-1"));
      GoalOutcome outcome = stage.goal("(>= (weight Box) 3)");
      MaestroAssertions.assertThat(outcome).isNotReached().tells(named);
      stage.goal("(>= (weight Box) 3)");
      assertThat(odd.lines("WEIGH")).hasSize(3);
    }
  }

  /** It says nothing for longer than it is waited for, and then that it is done. */
  @Test
  @Tag("full")
  void whoIsSlowIsAskedAgainAndDoesItOnce() throws Exception {
    isDoneOnce("slow", "28");
  }

  @Test
  @Tag("full")
  void whoSaysThatItIsAtItIsWaitedFor() throws Exception {
    isDoneOnce("busy", "50");
  }

  private void isDoneOnce(String... way) throws Exception {
    try (Stage stage = stage();
        Odd odd = new Odd(stage.broker(), way)) {
      stage.await("the odd one", () -> stage.platform().presentMembers().contains("odd-1"));
      GoalOutcome outcome = stage.goal("(bright Box)");
      MaestroAssertions.assertThat(outcome).isReached().hasCalls(1);
      assertThat(odd.lines("POLISH")).hasSize(1);
    }
  }

  private static Stage stage() throws IOException, InterruptedException {
    assumeTrue(
        PythonDeviceInAPlanTest.hasPython(),
        "python3 with paho-mqtt is not installed; .ci/run installs them");
    return Stage.paced(
        new SiteSettings(
            SITE, home(), Optional.empty(), 1, Optional.empty(), 0, false, Optional.empty()));
  }

  private static Home home() throws IOException {
    try (InputStream text = OddDevicesTest.class.getResourceAsStream("/homes/odd.ttl")) {
      return new HomeLoader()
          .load(new String(text.readAllBytes(), StandardCharsets.UTF_8), "odd.ttl");
    }
  }

  /** The process, and what it prints. */
  private final class Odd implements AutoCloseable {
    private final Path printed = directory.resolve("odd.txt");
    private final Process process;

    Odd(URI broker, String... way) throws Exception {
      Path script = Path.of(OddDevicesTest.class.getResource("/devices/odd.py").toURI());
      List<String> command =
          new ArrayList<>(
              List.of(
                  "python3",
                  script.toString(),
                  broker.getHost(),
                  String.valueOf(broker.getPort()),
                  SITE));
      command.addAll(List.of(way));
      process =
          new ProcessBuilder(command)
              .redirectErrorStream(true)
              .redirectOutput(printed.toFile())
              .start();
    }

    List<String> lines(String word) throws IOException {
      return Files.readAllLines(printed).stream().filter(line -> line.startsWith(word)).toList();
    }

    @Override
    public void close() {
      process.destroyForcibly();
    }
  }
}
