package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.experiment.Experiments;

/** What can be asked for wrongly is refused before anything runs. */
class ExperimentCommandTest {
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
