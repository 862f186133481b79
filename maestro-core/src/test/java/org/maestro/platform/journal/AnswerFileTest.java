package org.maestro.platform.journal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Instant;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.coordination.api.GivenAnswer;
import org.maestro.coordination.api.Respondent;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.time.PacedClock;
import org.maestro.rats.time.SteppedClock;

/** Answers to questions of scripts, kept beyond the process that took them. */
class AnswerFileTest {
  @TempDir private Path directory;

  private final SteppedClock clock = new SteppedClock();

  private static GivenAnswer given(String part, String answer, Optional<String> person) {
    return new GivenAnswer(
        Instant.parse("2026-11-29T19:30:00Z"),
        "survey",
        "(survey Dave)",
        part,
        "Dave",
        new Respondent("desk", person),
        "How \"was\" it?",
        answer);
  }

  @Test
  void whatWasKeptIsThereForTheNextProcess() {
    GivenAnswer first = given("G1.1", "fair,\nor so", Optional.empty());
    GivenAnswer second = given("G1.2", "3", Optional.of("Eve"));
    try (AnswerFile file = AnswerFile.open(directory, clock)) {
      assertThat(file.latest()).isEmpty();
      file.keep(first, () -> {});
      file.keep(second, () -> {});
    }
    try (AnswerFile file = AnswerFile.open(directory, clock)) {
      assertThat(file.latest()).containsExactly(first, second);
      assertThat(file.latest()).extracting(GivenAnswer::person).containsExactly("Dave", "Eve");
    }
  }

  @Test
  void aLineThatWasCutShortIsLeftOutAndTheNextOneIsWhole() throws IOException {
    Path lines = directory.resolve("answers.jsonl");
    GivenAnswer before = given("G1.1", "good", Optional.empty());
    GivenAnswer after = given("G2.1", "bad", Optional.empty());
    try (AnswerFile file = AnswerFile.open(directory, clock)) {
      file.keep(before, () -> {});
    }
    Files.writeString(lines, "{\"at\":\"2026-11-2", StandardOpenOption.APPEND);
    try (AnswerFile file = AnswerFile.open(directory, clock)) {
      assertThat(file.latest()).containsExactly(before);
      file.keep(after, () -> {});
    }
    try (AnswerFile file = AnswerFile.open(directory, clock)) {
      assertThat(file.latest()).containsExactly(before, after);
    }
  }

  @Test
  void whoGaveItIsToldOnceItIsOnTheDisk() throws Exception {
    PacedClock paced = new PacedClock(1);
    try (AnswerFile file = AnswerFile.open(directory, paced)) {
      CompletableFuture<String> written = new CompletableFuture<>();
      file.keep(
          given("G1.1", "good", Optional.empty()),
          () -> written.complete(text(directory.resolve("answers.jsonl"))));
      assertThat(written.get(10, TimeUnit.SECONDS)).contains("\"answer\":\"good\"").endsWith("\n");
    } finally {
      paced.close();
    }
  }

  private static String text(Path file) {
    try {
      return Files.readString(file);
    } catch (IOException e) {
      return e.toString();
    }
  }

  @Test
  void aFileThatCannotBeReadIsASentence() throws IOException {
    Files.createDirectories(directory.resolve("answers.jsonl"));
    assertThatThrownBy(() -> AnswerFile.open(directory, clock))
        .isInstanceOf(PlatformStartException.class)
        .hasMessageStartingWith("The answers in " + directory.resolve("answers.jsonl"))
        .hasMessageEndingWith("mend that, or name another directory.");
  }
}
