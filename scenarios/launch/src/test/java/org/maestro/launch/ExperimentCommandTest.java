package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.maestro.experiment.Experiments;

/** What can be asked for wrongly is refused before anything runs. */
class ExperimentCommandTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);

  /** A shell that starts them in the background has them, and all they start, ignore INT. */
  private static final List<String> LISTENING_TO_SIGNALS = List.of("env", "--default-signal=INT");

  @TempDir private Path directory;
  private final ByteArrayOutputStream out = new ByteArrayOutputStream();
  private final ByteArrayOutputStream err = new ByteArrayOutputStream();

  @Test
  void wrongArgumentsAreOneSentence() throws Exception {
    refused("There is no experiment tea; there are move-object", "tea");
    refused("--runs lies between 1 and", "move-object", "--runs", "0");
    refused("'one' is no whole number that fits", "move-object", "--runs", "one");
    refused("Nothing here is called world.moon", "move-object", "--set", "world.moon=1");
    refused("is true or false", "over-exposure", "--set", "world.shutters=maybe");
    refused("is true or false", "move-object", "--set", "world.shutters=maybe");
    refused("should be in KEY=VALUE format", "move-object", "--set", "world.shutters");
    Path file = Files.createFile(directory.resolve("file"));
    refused("name a directory with --out", "move-object", "--out", file.toString());
  }

  @Test
  void whereNothingCanBeWrittenIsSaidBeforeAnythingRuns() throws Exception {
    Path below = Files.createFile(directory.resolve("file")).resolve("below");

    assertThat(execute("move-object", "--out", below.toString())).isEqualTo(ExitCode.OUTSIDE);
    assertThat(err.toString(StandardCharsets.UTF_8))
        .isEqualTo(
            "maestro: The directory %s cannot be written to; name another one with --out.%n"
                .formatted(below));
  }

  @Test
  void withoutANameItTellsWhatThereIs() {
    assertThat(execute()).isZero();
    assertThat(out.toString(StandardCharsets.UTF_8).lines()).hasSameSizeAs(Experiments.all());
  }

  /** The test ends it when the first run is told to be over; the second is under way then. */
  @ParameterizedTest
  @CsvSource({"TERM, 143", "INT, 130"})
  void whatWasFinishedWhenItIsInterruptedIsKept(String signal, int exitCode) throws Exception {
    try (JavaProcess process =
        JavaProcess.start(
            LISTENING_TO_SIGNALS,
            Maestro.class.getName(),
            List.of(
                "experiment",
                "broken-cup",
                "--runs",
                "50000",
                "--json",
                "--out",
                directory.toString()),
            Map.of())) {
      Awaitility.await()
          .pollInterval(Duration.ofMillis(5))
          .atMost(LIMIT)
          .until(() -> process.errors().contains("1 of 50000: ") || !process.isAlive());

      process.signal(signal);

      JavaProcess.Ended ended = process.await(LIMIT);
      assertThat(ended.exitCode()).as(ended.errors()).isEqualTo(exitCode);
      JsonNode findings = CommandSchemas.valid("experiment", ended.output());
      int done = findings.path("runs_done").asInt();
      assertThat(done).isBetween(1, 49_999);
      assertThat(findings.path("runs_asked").asInt()).isEqualTo(50_000);
      String interrupted = "Interrupted after %d of 50000 runs".formatted(done);
      assertThat(ended.errors()).contains(interrupted + ".").doesNotContain("maestro: ");
      assertThat(Files.readString(directory.resolve("index.html"))).contains(interrupted);
      assertThat(Files.readAllLines(directory.resolve("runs.csv"))).hasSize(1 + done);
    }
  }

  private void refused(String part, String... arguments) {
    out.reset();
    err.reset();
    assertThat(execute(arguments)).isEqualTo(ExitCode.BAD_INPUT);
    assertThat(out.size()).isZero();
    assertThat(err.toString(StandardCharsets.UTF_8))
        .startsWith("maestro: ")
        .contains(part)
        .doesNotContain("\tat ");
  }

  private int execute(String... arguments) {
    String[] all = new String[arguments.length + 1];
    all[0] = "experiment";
    System.arraycopy(arguments, 0, all, 1, arguments.length);
    return Maestro.commandLine(
            new PrintStream(out, true, StandardCharsets.UTF_8),
            new PrintStream(err, true, StandardCharsets.UTF_8))
        .execute(all);
  }
}
