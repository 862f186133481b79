package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The scripts do in the shells themselves what they are for. */
class CompletionCommandTest {
  private static final String IN_BASH =
      """
      source %s
      compopt() { :; }
      COMP_LINE='%s'; COMP_POINT=${#COMP_LINE}; read -ra COMP_WORDS <<< "$COMP_LINE"
      [[ "$COMP_LINE" == *' ' ]] && COMP_WORDS+=('')
      COMP_CWORD=$((${#COMP_WORDS[@]} - 1))
      _complete_maestro
      printf '%%s\\n' "${COMPREPLY[@]}"
      """;

  @TempDir private Path directory;

  @ParameterizedTest
  @CsvSource({
    "maestro go,                        goal goals",
    "./maestro run b,                   bob",
    "./maestro run bob --scene bob-l,   bob-lit",
    "./maestro goal --j,                --json",
    "maestro agent re,                  reconfigure remove",
    "maestro completion z,              zsh",
  })
  void completesInBashAndInFish(String typed, String completions) throws Exception {
    assertThat(shell("bash", IN_BASH.formatted(script("bash"), typed)))
        .containsExactlyInAnyOrder(completions.split(" "));

    assertThat(
            shell("fish", "source %s\ncomplete -C '%s'".formatted(script("fish"), typed)).stream()
                .map(line -> line.split("\t")[0]))
        .containsExactlyInAnyOrder(completions.split(" "));
  }

  @Test
  void zshTakesItWithoutAWord() throws Exception {
    String sourced = "source %s\nprint -- ${_comps[maestro]}".formatted(script("zsh"));

    assertThat(shell("zsh", "autoload -U compinit && compinit -D\n" + sourced))
        .singleElement()
        .asString()
        .contains("_complete_maestro");
  }

  @Test
  void anotherShellIsRefusedWithThoseThereAre() {
    assertThat(said("completion", "tcsh")).containsIgnoringCase("bash, zsh, fish");
  }

  private static String said(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    Maestro.commandLine(stream, stream).execute(arguments);
    return said.toString(StandardCharsets.UTF_8);
  }

  private Path script(String shell) throws IOException {
    return Files.writeString(directory.resolve("completion." + shell), said("completion", shell));
  }

  private List<String> shell(String name, String commands) throws Exception {
    assumeTrue(
        Stream.of(System.getenv("PATH").split(":"))
            .anyMatch(path -> Files.isExecutable(Path.of(path, name))),
        name + " is not installed; .ci/run installs it");
    Path file = Files.writeString(directory.resolve("commands." + name), commands);
    ProcessBuilder builder =
        new ProcessBuilder(name, file.toString()).directory(directory.toFile());
    builder.redirectErrorStream(true).environment().put("HOME", directory.toString());
    Process process = builder.start();
    String printed = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(process.waitFor(30, TimeUnit.SECONDS)).isTrue();
    return printed.lines().filter(line -> !line.isBlank()).toList();
  }
}
