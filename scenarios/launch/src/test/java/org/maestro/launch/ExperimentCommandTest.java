package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
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

  /** Bob's home as it is shipped, as a file of somebody's own; of the other the lamps in room B. */
  private Path home(String name, boolean hasLampsInB) throws IOException {
    String bob = Shipped.text("/homes/bob.ttl").orElseThrow();
    return Files.writeString(
        directory.resolve(name),
        hasLampsInB ? bob : bob.replaceAll("home:lamp-b\\d [^.]*(?:\\.\\d[^.]*)*\\.\\n", ""));
  }

  /** In the dark nobody finds the cup; the scene speaks of lamps that only one of the homes has. */
  @Test
  void ofTwoHomesTheBetterOneComesOutForAReason() throws IOException {
    Path goals =
        Files.writeString(
            directory.resolve("goals.txt"),
            "# what is wanted of an evening\n"
                + "(>= (illuminance zone-a) 72)\n\n"
                + "5.5 (nextTo Cup Bob)\n");

    assertThat(
            execute(
                "setups",
                "--home",
                home("dim.ttl", false).toString(),
                "--home",
                home("lit.ttl", true).toString(),
                "--scene",
                "bob-lit",
                "--goals",
                goals.toString(),
                "--runs",
                "2",
                "--out",
                directory.resolve("found").toString()))
        .as(err.toString(StandardCharsets.UTF_8))
        .isZero();

    String told = out.toString(StandardCharsets.UTF_8);
    assertThat(told.lines().filter(line -> line.startsWith("goals reached")).toList())
        .singleElement()
        .asString()
        .contains("2 of 4", "4 of 4");
    assertThat(told)
        .contains(
            "lit.ttl reaches (nextTo Cup Bob) more often than dim.ttl: 2 of 2 against 0 of 2, a"
                + " difference of +100 (+7 to +100) %.")
        .contains("dim.ttl, (nextTo Cup Bob), not reached in 2 runs: ")
        .doesNotContain("reaches (>= (illuminance zone-a) 72)")
        .doesNotContain("Nothing is claimed");
    assertThat(told.lines().filter(line -> line.startsWith("dim.ttl, ")))
        .allMatch(line -> line.contains("illuminance") && line.contains("zone-b"));
    assertThat(Files.readString(directory.resolve("found/index.html")))
        .contains("lit.ttl reaches (nextTo Cup Bob) more often than dim.ttl")
        .contains("5.5 s after the evening's begin")
        .contains("--scene bob-lit --goals " + goals);
    assertThat(Files.readAllLines(directory.resolve("found/runs.csv"))).hasSize(1 + 2 * 2 * 2);
  }

  @Test
  void ofTwoEqualHomesNothingIsClaimed() throws IOException {
    assertThat(
            execute(
                "setups",
                "--home",
                home("one.ttl", true).toString(),
                "--home",
                home("other.ttl", true).toString(),
                "--scene",
                "bob-lit",
                "--goal",
                "(nextTo Cup Bob)",
                "--runs",
                "2",
                "--json",
                "--out",
                directory.resolve("found").toString()))
        .as(err.toString(StandardCharsets.UTF_8))
        .isZero();

    JsonNode findings = CommandSchemas.valid("experiment", out.toString(StandardCharsets.UTF_8));
    assertThat(findings.path("sentences"))
        .extracting(JsonNode::asText)
        .containsExactly(
            "Nothing is claimed: there is no difference of which the interval leaves out 0.");
    assertThat(findings.path("results"))
        .filteredOn(
            result -> result.path("name").asText().startsWith("other.ttl more than one.ttl"))
        .hasSizeGreaterThan(9)
        .filteredOn(result -> !result.path("name").asText().matches(".*: reached, at (least|most)"))
        .allMatch(result -> result.path("value").asDouble() == 0);
  }

  @Test
  void whatCannotBeComparedIsOneSentence() throws Exception {
    String dim = home("dim.ttl", false).toString();
    String lit = home("lit.ttl", true).toString();
    String[] both = {"setups", "--home", dim, "--home", lit, "--scene", "bob-lit"};

    refused(
        "In dim.ttl the goal (>= (level lamp-b1) 1) cannot be stated, so that nothing is compared:"
            + " ",
        with(both, "--goal", "(>= (level lamp-b1) 1)"));
    refused(
        "Two homes at least",
        "setups",
        "--home",
        lit,
        "--scene",
        "bob-lit",
        "--goal",
        "(open door-ab)");
    refused("Nothing is wanted in these homes", both);
    refused("has no end at which", with(both, "--goal", "(keep (open door-ab))"));
    refused("There is no goals file nowhere.txt", with(both, "--goals", "nowhere.txt"));
    Path goals = Files.writeString(directory.resolve("goals.txt"), "\nbring the cup\n");
    refused(
        ":2: bring the cup is no goal; write one a line", with(both, "--goals", goals.toString()));
    refused("2 homes are to be compared, and 0 scenes", "setups", "--home", dim, "--home", lit);
    refused("not with move-object", "move-object", "--goal", "(open door-ab)");
  }

  private static String[] with(String[] words, String... more) {
    return Stream.concat(Arrays.stream(words), Arrays.stream(more)).toArray(String[]::new);
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
