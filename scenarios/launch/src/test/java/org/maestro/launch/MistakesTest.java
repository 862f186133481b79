package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Every kind of mistake is told by {@code check}: where it is, what is wrong, and what to do. */
class MistakesTest {

  private static final Pattern SAID = Pattern.compile("(Warning: )?([^:]+):(\\d+): (.*; .*)");

  @TempDir private Path directory;

  /** What {@code check} printed. */
  private record Said(int exitCode, List<String> lines) {}

  static Stream<Mistake> homes() {
    return Mistake.all("/mistakes/homes.txt");
  }

  @ParameterizedTest
  @MethodSource("homes")
  void ofAHomeIsTold(Mistake mistake) throws IOException {
    String wrong = mistake.in(Shipped.text("/homes/bob.ttl").orElseThrow());
    Path file = Files.writeString(directory.resolve("mine.ttl"), wrong);
    assertTold(mistake, wrong, "mine.ttl", check(file.toString()));
  }

  @ParameterizedTest
  @ValueSource(
      strings = {"bob", "bob-two-robots", "arena", "arena-windows", "flat", "study", "broken-cup"})
  void noneIsInAShippedHome(String home) {
    Said said = check(home);
    assertThat(said.exitCode()).isZero();
    assertThat(said.lines()).singleElement().asString().startsWith(home + ": no fault; ");
  }

  /** Exactly what is expected, at the lines where it is expected. */
  private static void assertTold(Mistake mistake, String wrong, String file, Said said) {
    List<String> lines = wrong.lines().toList();
    List<Mistake.Finding> found =
        said.lines().subList(0, said.lines().size() - 1).stream()
            .map(
                line -> {
                  Matcher parts = SAID.matcher(line);
                  assertThat(parts.matches()).as(line).isTrue();
                  assertThat(parts.group(2)).isEqualTo(file);
                  return new Mistake.Finding(
                      parts.group(1) == null,
                      parts.group(4),
                      lines.get(Integer.parseInt(parts.group(3)) - 1).strip());
                })
            .toList();
    assertThat(found).containsExactlyElementsOf(mistake.findings());
    boolean isFaulty = mistake.findings().stream().anyMatch(Mistake.Finding::isFault);
    assertThat(said.exitCode()).isEqualTo(isFaulty ? ExitCode.NOT_REACHED : ExitCode.DONE);
  }

  private static Said check(String... arguments) {
    ByteArrayOutputStream said = new ByteArrayOutputStream();
    PrintStream stream = new PrintStream(said, true, StandardCharsets.UTF_8);
    int code =
        Maestro.commandLine(stream, stream)
            .execute(
                Stream.concat(Stream.of("check"), Stream.of(arguments)).toArray(String[]::new));
    return new Said(code, said.toString(StandardCharsets.UTF_8).lines().toList());
  }
}
