package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.faults.FaultyDisk;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.api.Store;
import org.maestro.knowledge.history.HistoryFile;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** Who said what, when and how surely: kept for the configured time, and over a restart. */
public class HistoryTest {

  private static final Source CAM_A = new Source(Source.Kind.OBSERVED, "cam-a");
  private static final String OBSERVATIONS =
      "SELECT ?o WHERE { GRAPH <https://example.org/home#graph/observations>"
          + " { ?o <https://w3id.org/maestro#fact> ?f } }";

  @TempDir private Path directory;

  /** Where the dataset is kept. */
  Store store() {
    return Store.IN_MEMORY;
  }

  @Test
  void statementsOlderThanTheKeptTimeGoButForTheLastOfEach() {
    Household home =
        new Household(
            new KnowledgeSettings(Duration.ofMinutes(5), 100, Optional.empty()).with(store()));
    home.state(CAM_A, "(= (level lamp-b1) 1)");
    home.state(CAM_A, "(in Cup zone-a)");
    home.pass(Duration.ofMinutes(4));
    home.state(CAM_A, "(in Cup zone-b)");
    assertThat(home.knowledge.history("(in Cup zone-a)")).hasSize(2);

    home.pass(Duration.ofMinutes(4));
    home.state(CAM_A, "(in Cup rose)");

    assertThat(home.knowledge.history("(in Cup zone-a)"))
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-b)", "(in Cup rose)");
    assertThat(home.knowledge.history("(= (level lamp-b1) 0)")).hasSize(1);
    assertThat(home.knowledge.select(OBSERVATIONS)).hasSize(3);
    home.knowledge.close();
  }

  @Test
  void aStreamDoesNotFillTheMemory() {
    Household home =
        new Household(
            new KnowledgeSettings(Duration.ofDays(1), 20, Optional.empty()).with(store()));
    for (int i = 0; i < 500; i++) {
      home.state(CAM_A, "(position Cup \"1." + i + " 0 0\")");
      home.pass(Duration.ofMillis(33));
    }
    for (int i = 0; i < 500; i++) {
      home.state(CAM_A, "(= (illuminance zone-a) 80)");
      home.pass(Duration.ofMillis(33));
    }

    assertThat(home.knowledge.history("(position Cup \"0 0 0\")")).hasSize(20);
    assertThat(home.knowledge.history("(= (illuminance zone-a) 0)"))
        .as("the same again and again is written once in a while")
        .hasSize(1);
    assertThat(home.knowledge.select(OBSERVATIONS)).hasSizeLessThan(50);
    assertThat(home.knowledge.snapshot().beliefs())
        .filteredOn(belief -> belief.fact().startsWith("(= (illuminance"))
        .extracting(belief -> belief.age(home.clock.instant()))
        .containsExactly(Duration.ofMillis(33));
    home.knowledge.close();
  }

  @Test
  void whatIsKeptIsBoundedInBytesButForTheLastOfEach() {
    int most = 60 << 10;
    Household home =
        new Household(
            new KnowledgeSettings(Duration.ofDays(1), 1_000_000, Optional.empty())
                .with(store())
                .with(most));
    home.state(CAM_A, "(in Cup zone-a)");
    for (int i = 0; i < 150; i++) {
      home.state(CAM_A, "(position Cup \"1." + i + " 0 0\")", "(= (level lamp-b1) " + i + ")");
      home.pass(Duration.ofMillis(33));
    }

    List<Belief> positions = home.knowledge.history("(position Cup \"0 0 0\")");
    assertThat(positions).hasSizeBetween(3, most / 512 / 2);
    assertThat(positions.get(positions.size() - 1).fact()).contains("1.149 0 0");
    List<Belief> levels = home.knowledge.history("(= (level lamp-b1) 0)");
    assertThat(levels)
        .as("the oldest go first, whatever they are about")
        .hasSizeBetween(positions.size() - 1, positions.size() + 1);
    assertThat(home.knowledge.history("(in Cup zone-a)")).hasSize(1);
    assertThat(home.knowledge.select(OBSERVATIONS)).hasSize(positions.size() + levels.size() + 1);
    home.knowledge.close();
  }

  @Test
  void afterARestartWhatWasSaidIsRememberedButNotBelieved() {
    Household before = new Household(KnowledgeSettings.in(directory).with(store()));
    before.state(CAM_A, "(in Cup zone-a)", "(= (illuminance zone-a) 80.5)");
    before.state(CAM_A, "(not (in Bob zone-b))");
    before.knowledge.close();

    Household after = new Household(KnowledgeSettings.in(directory).with(store()));

    assertThat(after.knowledge.history("(in Cup zone-b)"))
        .containsExactly(new Belief("(in Cup zone-a)", CAM_A, before.clock.instant(), 1));
    assertThat(after.knowledge.history("(not (in Bob zone-a))")).hasSize(1);
    assertThat(after.truth("(in Cup zone-a)")).isEqualTo(Truth.UNKNOWN);
    assertThat(after.number("(illuminance zone-a)")).isEmpty();
    assertThat(after.knowledge.snapshot().lastKnown("in", List.of(new Term.Name("Cup"))))
        .map(Belief::fact)
        .contains("(in Cup zone-a)");
    assertThat(after.knowledge.select(OBSERVATIONS)).hasSize(3);
    after.state(CAM_A, "(in Cup zone-b)");
    assertThat(after.knowledge.history("(in Cup zone-b)")).hasSize(2);
    after.knowledge.close();

    Household third = new Household(KnowledgeSettings.in(directory).with(store()));
    assertThat(third.knowledge.history("(in Cup zone-b)"))
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-a)", "(in Cup zone-b)");
    third.knowledge.close();
  }

  @Test
  void whatAKilledProcessWroteLastIsLeftOutWhenItIsNotWhole() throws IOException {
    Household before = new Household(KnowledgeSettings.in(directory).with(store()));
    before.state(CAM_A, "(in Cup zone-a)");
    Path file;
    try (Stream<Path> files = Files.list(directory)) {
      file = files.findFirst().orElseThrow();
    }
    Files.writeString(
        file, "2026-01-01T00:00:00Z\tobserved\tcam-a\t1\tbelie", StandardOpenOption.APPEND);

    Household after = new Household(KnowledgeSettings.in(directory).with(store()));

    assertThat(after.knowledge.history("(in Cup zone-a)")).hasSize(1);
    before.knowledge.close();
    after.knowledge.close();
  }

  @Test
  void goesOnWhenTheDiskDoes() {
    FaultyDisk disk = new FaultyDisk(1);
    Household before = new Household(KnowledgeSettings.in(disk.path(directory)).with(store()));
    before.state(CAM_A, "(in Cup zone-a)");
    disk.fillUpTo(10);
    before.state(CAM_A, "(in Cup zone-b)");
    assertThat(before.knowledge.history("(in Cup zone-a)")).as("in memory").hasSize(2);
    disk.heal();
    before.state(CAM_A, "(in Cup rose)");
    before.knowledge.close();

    Household after = new Household(KnowledgeSettings.in(directory).with(store()));
    assertThat(after.knowledge.history("(in Cup zone-a)"))
        .extracting(Belief::fact)
        .containsExactly("(in Cup zone-a)", "(in Cup rose)");
    after.knowledge.close();
  }

  @Test
  void filesInWhichAllIsTooOldAreDeleted() throws IOException {
    for (int run = 0; run < 3; run++) {
      Household home = new Household(KnowledgeSettings.in(directory).with(store()));
      home.state(CAM_A, "(in Cup zone-a)");
      home.knowledge.close();
    }
    HistoryFile file = new HistoryFile(directory, Duration.ofDays(1));

    file.read(new Household().clock.instant().plus(Duration.ofDays(2)), line -> {});

    try (Stream<Path> files = Files.list(directory)) {
      assertThat(files).hasSize(1);
    }
  }

  @Test
  void aDirectoryThatCannotBeUsedIsToldInOneSentence() throws IOException {
    Path notADirectory = directory.resolve("taken");
    Files.write(notADirectory, "x".getBytes(StandardCharsets.UTF_8));

    assertThatThrownBy(() -> new Household(KnowledgeSettings.in(notADirectory)))
        .isInstanceOf(KnowledgeException.class)
        .hasMessageContaining("cannot be read");
  }
}
