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
import org.junit.jupiter.api.Test;
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

  static Stream<Mistake> scenes() {
    return Mistake.all("/mistakes/scenes.txt");
  }

  @ParameterizedTest
  @MethodSource("scenes")
  void ofASceneIsTold(Mistake mistake) throws IOException {
    String wrong = mistake.in(Shipped.text("/scenes/bob-dark.ttl").orElseThrow());
    Path file = Files.writeString(directory.resolve("evening.ttl"), wrong);
    assertTold(mistake, wrong, "evening.ttl", check("bob", "--scene", file.toString()));
  }

  static Stream<Mistake> descriptions() {
    return Mistake.all("/mistakes/descriptions.txt");
  }

  @ParameterizedTest
  @MethodSource("descriptions")
  void ofADescriptionIsTold(Mistake mistake) throws IOException {
    String wrong = mistake.in(Shipped.text("/mistakes/bell.jsonld").orElseThrow());
    Path file = Files.writeString(directory.resolve("bell.jsonld"), wrong);
    assertTold(mistake, wrong, file.toString(), check(file.toString()));
  }

  @Test
  void noneIsInADescriptionWithWordsOfOthers() throws IOException {
    String others =
        Shipped.text("/mistakes/bell.jsonld")
            .orElseThrow()
            .replace("\"label\":", "\"s:serialNumber\": 17, \"label\":")
            .replace("#\"}],", "#\", \"s\": \"https://schema.org/\", \"maker\": \"s:brand\"}],")
            .replace("\"cost\": \"0.5\"", "\"cost\": \"0.5\", \"maker\": \"Bim\"");
    Path file = Files.writeString(directory.resolve("bell.jsonld"), others);
    Said said = check(file.toString());
    assertThat(said.exitCode()).isZero();
    assertThat(said.lines())
        .containsExactly("bell-1 could join, and would offer ring, wind.", file + ": no fault.");
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "bob",
        "bob-two-robots",
        "arena",
        "arena-windows",
        "flat",
        "household",
        "livingroom",
        "study",
        "broken-cup",
        "evening"
      })
  void noneIsInAShippedHome(String home) {
    Said said = check(home);
    assertThat(said.exitCode()).isZero();
    assertThat(said.lines()).singleElement().asString().startsWith(home + ": no fault; ");
  }

  /** Exactly what is expected, at the lines where it is expected. */
  private static void assertTold(Mistake mistake, String wrong, String file, Said said) {
    List<String> lines = wrong.lines().toList();
    List<Mistake.Finding> found =
        said.lines().stream()
            .limit(mistake.findings().size())
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
    assertThat(said.lines().subList(found.size(), said.lines().size()))
        .as("no more than that")
        .noneMatch(line -> SAID.matcher(line).matches());
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
