package org.maestro.launch;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.api.parallel.Isolated;

/**
 * A question of a script is answered from the command line, and stays one while the platform is
 * killed and started again; an answer that was taken is not asked for twice, and is kept.
 */
@Isolated("its time is wall time, which others beside it would take")
class AnswerCommandTest {
  private static final Duration LIMIT = Duration.ofSeconds(60);
  private static final String ASKING =
      "Asks Bob: \"How bright?\" Answer by ./maestro answer G1.1, ";

  @TempDir private Path directory;

  private Path home() throws IOException {
    return Files.writeString(
        directory.resolve("bob.ttl"),
        Files.readString(Path.of("../assembly/src/main/resources/homes/bob.ttl"))
            + """

            home:brighten a maestro:Script ;
              maestro:body \"""(seq (ask Bob "How bright?" ?lux double)
                (ask Bob "Now?" ?now boolean) (say Bob "It will be" ?lux "lux."))\""" .
            """);
  }

  @Test
  @Tag("full")
  void aQuestionOutlivesThePlatformAndItsAnswerToo() throws Exception {
    String home = home().toString();
    String data = directory.resolve("data").toString();
    try (JavaProcess platform = platform(home, data)) {
      try (JavaProcess script = maestro("run-script", "brighten")) {
        awaitQuestion("How bright?");
        assertThat(ended("answer", "G1.1", "quite"))
            .isEqualTo(
                "2 maestro: G1.1 is not answered by \"quite\"; write a number, such as 21.5.");
        assertThat(ended("answer", "G1.3", "7"))
            .isEqualTo(
                "2 maestro: There is no open question G1.3; ./maestro goals shows who waits for an answer.");
        assertThat(ended("goals")).contains("waiting").contains("for an answer of Bob");
        assertThat(script.isAlive()).isTrue();
      }
      platform.kill();
    }
    try (JavaProcess platform = platform(home, data)) {
      awaitQuestion("How bright?");
      assertThat(ended("answer", "G1.1", "40")).isEqualTo("0 G1.1 is answered.");
      platform.kill();
    }
    try (JavaProcess platform = platform(home, data)) {
      awaitQuestion("Now?");
      assertThat(ended("answer", "G1.1.1.1", "yes")).isEqualTo("0 G1.1.1.1 is answered.");
      Awaitility.await()
          .atMost(LIMIT)
          .untilAsserted(() -> assertThat(story()).contains("To Bob: \"It will be 40 lux.\""));
      assertThat(story().split(Pattern.quote(ASKING), -1))
          .as("asked once in each of two lives")
          .hasSize(3);
      assertThat(ended("answers", "brighten", "--csv").lines())
          .satisfiesExactly(
              head -> assertThat(head).startsWith("0 \"at\",\"person\",\"question\",\"answer\""),
              first -> assertThat(first).contains("\"Bob\",\"How bright?\",\"40\",\"brighten\""),
              second -> assertThat(second).contains("\"Bob\",\"Now?\",\"true\",\"brighten\""));
      assertThat(ended("answers", "dim"))
          .isEqualTo("0 Nobody has answered anything to a script named dim yet.");
      String document = ended("answers", "--json").substring("0 ".length());
      assertThat(CommandSchemas.valid("answers", document).path("answers").findValuesAsText("part"))
          .containsExactly("G1.1", "G1.1.1.1");
      assertThat(platform.isAlive()).isTrue();
    }
  }

  private JavaProcess platform(String home, String data) throws IOException {
    JavaProcess platform =
        maestro("run", home, "--port", "0", "--speed", "20", "--data", data, "--scene", "bob-dark");
    Awaitility.await()
        .atMost(LIMIT)
        .until(() -> platform.output().contains(" runs: ") || !platform.isAlive());
    assertThat(platform.isAlive()).as(platform.output() + platform.errors()).isTrue();
    return platform;
  }

  private void awaitQuestion(String text) {
    Awaitility.await()
        .atMost(LIMIT)
        .untilAsserted(
            () -> assertThat(ended("goals")).contains("for an answer of Bob to \"" + text));
  }

  /** Sentences are broken into lines. */
  private String story() throws Exception {
    return ended("why", "G1").replaceAll("\\s+", " ");
  }

  private String ended(String... arguments) throws Exception {
    try (JavaProcess process = maestro(arguments)) {
      JavaProcess.Ended ended = process.await(LIMIT);
      return ended.exitCode() + " " + (ended.output() + ended.errors()).strip();
    }
  }

  private JavaProcess maestro(String... arguments) throws IOException {
    return JavaProcess.start(
        Maestro.class.getName(),
        List.of(arguments),
        Map.of("XDG_RUNTIME_DIR", directory.toString()));
  }
}
