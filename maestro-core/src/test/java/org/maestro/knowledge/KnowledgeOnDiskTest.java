package org.maestro.knowledge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.Nested;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.KnowledgeSettings;
import org.maestro.knowledge.api.Store;
import org.maestro.knowledge.rdf.DatasetStorage;

/**
 * All that is asked of the collective knowledge, with its dataset on disk. As each test makes files
 * of its own and forces them, most run in the full build only.
 */
class KnowledgeOnDiskTest {
  @TempDir static Path directory;

  private static Store fresh() {
    try {
      return new Store.OnDisk(Files.createTempDirectory(directory, "store"));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Test
  void aStoreThatCannotBeUsedIsToldInOneSentence() throws IOException {
    Path taken = Files.writeString(directory.resolve("taken"), "a file");
    assertThatThrownBy(() -> new Household(new Store.OnDisk(taken)))
        .isInstanceOf(KnowledgeException.class)
        .hasMessageContaining("The store in " + taken + " cannot be used")
        .message()
        .doesNotContain("\n");
  }

  /** What is said meanwhile waits, and nothing of it is written by half. */
  @Test
  void aFullDiskIsWaitedFor() throws Exception {
    Path disk = Files.createDirectory(directory.resolve("disk"));
    assumeTrue(
        ran("mount", "-t", "tmpfs", "-o", "size=48m", "tmpfs", disk.toString()),
        "no file system can be mounted here; root can");
    try {
      Household home = new Household(new Store.OnDisk(disk.resolve("store")));
      home.state(Household.ROBOT, "(= (level rose) 1)");
      Path filling = Files.write(disk.resolve("filling"), new byte[30 << 20]);
      for (int level = 2; level <= 50; level++) {
        home.state(Household.ROBOT, "(= (level rose) %d)".formatted(level));
      }
      assertThatThrownBy(() -> home.knowledge.select("SELECT ?s WHERE { ?s ?p ?o }"))
          .hasMessageContaining("The store in " + disk.resolve("store"))
          .hasMessageContaining("of the 32 MiB that it needs to write, ")
          .message()
          .doesNotContain("\n");
      Files.delete(filling);
      home.close();
    } finally {
      ran("umount", "-l", disk.toString());
    }
  }

  private static boolean ran(String... command) throws Exception {
    try {
      return new ProcessBuilder(command).start().waitFor() == 0;
    } catch (IOException e) {
      return false;
    }
  }

  /** Files that are cut, gone or full of something else, in stores of which each is a copy. */
  @Test
  void aDamagedStoreIsToldInOneSentenceThatSaysWhatToDo() throws IOException {
    Path whole = Files.createTempDirectory(directory, "whole");
    Household home = new Household(new Store.OnDisk(whole));
    home.state(Household.ROBOT, "(in Cup rose)");
    home.close();
    int complaints = 0;
    for (int seed = 0; seed < 60; seed++) {
      Path store = new DamagedStore(seed, whole).in(directory.resolve("damaged-" + seed));
      Optional<String> complaint = complaint(store);
      complaint.ifPresent(
          sentence ->
              assertThat(sentence)
                  .contains("The store in " + store)
                  .doesNotContain("\n")
                  .doesNotContain("Exception"));
      complaints += complaint.isPresent() ? 1 : 0;
    }
    assertThat(complaints).isGreaterThan(20);
  }

  private static Optional<String> complaint(Path store) {
    DatasetStorage storage;
    try {
      storage = DatasetStorage.onDisk(store);
    } catch (KnowledgeException e) {
      assertThat(e).hasMessageContaining("put a copy in its place");
      return Optional.of(e.getMessage());
    }
    try {
      storage.select("SELECT ?s ?p ?o WHERE { GRAPH ?g { ?s ?p ?o } }");
      return Optional.empty();
    } catch (KnowledgeException e) {
      assertThat(e).hasMessageContaining("put a copy in its place");
      return Optional.of(e.getMessage());
    } finally {
      storage.close();
    }
  }

  @Test
  void whatWasSaidIsRememberedAfterARestartAndNotBelieved() {
    LastingStore.rememberOverARestart(fresh());
  }

  /** Another process says what it has stored, until it is killed in the middle of it. */
  @Test
  void whatWasStoredSurvivesAKill() throws Exception {
    Path store = Files.createTempDirectory(directory, "killed");
    Path said = directory.resolve("said");
    Process process =
        new ProcessBuilder(
                Path.of(System.getProperty("java.home"), "bin", "java").toString(),
                "-XX:TieredStopAtLevel=1",
                "-cp",
                System.getProperty("java.class.path"),
                Chatterer.class.getName(),
                store.toString())
            .redirectOutput(said.toFile())
            .redirectError(ProcessBuilder.Redirect.DISCARD)
            .start();
    try {
      Awaitility.await()
          .atMost(Duration.ofSeconds(60))
          .until(() -> Files.readAllLines(said).size() >= 5 || !process.isAlive());
    } finally {
      process.destroyForcibly().onExit().join();
    }
    List<String> lines = Files.readAllLines(said);
    int stored = Integer.parseInt(lines.get(lines.size() - 1));

    Household after =
        new Household(
            new KnowledgeSettings(Duration.ofDays(1), Integer.MAX_VALUE, Optional.empty())
                .with(new Store.OnDisk(store)));
    assertThat(stored).isPositive();
    assertThat(after.knowledge.history("(= (level rose) 0)").stream().map(Belief::fact))
        .hasSizeGreaterThanOrEqualTo(stored)
        .startsWith("(= (level rose) 1)")
        .contains("(= (level rose) %d)".formatted(stored))
        .doesNotHaveDuplicates();
    after.state(Household.ROBOT, "(in Cup rose)");
    after.close();
  }

  /** States one number after the other, and tells which of them the store has. */
  static final class Chatterer {
    private static final int BETWEEN_READS = 20;

    public static void main(String[] arguments) {
      Household home =
          new Household(
              new KnowledgeSettings(Duration.ofDays(1), Integer.MAX_VALUE, Optional.empty())
                  .with(new Store.OnDisk(Path.of(arguments[0]))));
      for (int number = 1; ; number++) {
        home.state(Household.ROBOT, "(= (level rose) %d)".formatted(number));
        if (number % BETWEEN_READS == 0) {
          home.knowledge.select("SELECT ?s WHERE { ?s ?p ?o }");
          System.out.println(number);
        }
      }
    }
  }

  @Nested
  @Tag("full")
  class Statements extends CollectiveKnowledgeTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  @Tag("full")
  class Disagreement extends DisagreementTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  @Tag("full")
  class Learning extends LearningTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  @Tag("full")
  class Past extends HistoryTest {
    @Override
    Store store() {
      return fresh();
    }
  }

  @Nested
  class BobsHome extends BobsHomeKnowledgeTest {
    @Override
    Store store() {
      return fresh();
    }
  }
}
