package org.maestro.console.history;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * What is kept of the past: within its bounds, over a restart, and whatever becomes of the disk.
 */
class ArchiveTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final Instant START = Instant.parse("2026-01-01T12:00:00Z");
  private static final long[] PLENTY = {1L << 30};
  private static final Duration A_DAY = Duration.ofDays(1);

  @TempDir private Path directory;

  private static Archive inMemory(long mostBytes, Duration longest) {
    return new Archive(
        new Archive.Limits(mostBytes, longest, 2_000), new DiskCopy(Optional.empty()));
  }

  private Archive onDisk(Disk disk) {
    return new Archive(
        new Archive.Limits(1 << 20, A_DAY, 2_000),
        new DiskCopy(Optional.of(new HistoryFiles(directory, 20_000, A_DAY, disk))));
  }

  private static JsonNode json(String text) {
    try {
      return MAPPER.readTree(text.replace('\'', '"'));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** After so many seconds the lamp has this level, and none before. */
  private static Entry level(int second, double level) {
    return new Entry(
        START.plusSeconds(second),
        second * 20.0,
        Entry.Kind.FACTS,
        json(
            ("{'set': [{'fact': '(= (level lamp) %1$s)', 'word': 'level', 'arguments': ['lamp'],"
                    + " 'value': %1$s, 'age_s': 1.0}], 'gone': ['(= (level lamp) %2$s)']}")
                .formatted(level, level - 1)));
  }

  private static Entry figures(int second) {
    return new Entry(
        START.plusSeconds(second), second * 20.0, Entry.Kind.FIGURES, json("{'x': [1, 2, 3]}"));
  }

  private static JsonNode at(Archive archive, int second) {
    Instant at = START.plusSeconds(second);
    return archive.until(at).orElseThrow().document(at);
  }

  private static void fill(Archive archive, int from, int to) {
    for (int second = from; second < to; second++) {
      archive.add(level(second, second));
    }
  }

  @Test
  void eachMomentIsAsItWas() {
    Archive archive = inMemory(1 << 20, A_DAY);
    archive.begin(START, 0, 20);
    fill(archive, 1, 200);

    for (int second = 1; second < 200; second++) {
      JsonNode then = at(archive, second);
      assertThat(then.at("/facts")).hasSize(1);
      assertThat(then.at("/facts/0/value").asInt()).isEqualTo(second);
      assertThat(then.at("/facts/0/age_s").asDouble()).isEqualTo(1);
      assertThat(then.at("/former/0/value").asInt()).isEqualTo(second - 1);
      assertThat(then.path("clock_s").asDouble()).isEqualTo(second * 20.0);
    }
    assertThat(at(archive, 0).path("facts")).isEmpty();
    Instant between = START.plusMillis(100_500);
    JsonNode then = archive.until(between).orElseThrow().document(between);
    assertThat(then.at("/facts/0/age_s").asDouble()).as("by the platform's clock").isEqualTo(11);
  }

  @Test
  void theOldestIsForgottenWhenItIsTooMuch() {
    Archive archive = inMemory(50_000, A_DAY);
    archive.begin(START, 0, 20);
    fill(archive, 1, 2_000);

    assertThat(archive.weight()).isLessThan(60_000);
    assertThat(archive.until(START)).as("forgotten").isEmpty();
    Instant from = archive.span().orElseThrow().from();
    assertThat(from).isAfter(START);
    assertThat(at(archive, 1_999).at("/facts/0/value").asInt()).isEqualTo(1_999);
    assertThat(archive.until(from).orElseThrow().document(from).path("facts")).hasSize(1);
    assertThat(archive.samples(List.of("(level lamp)")).get("(level lamp)").get(0).at())
        .isEqualTo(from.toEpochMilli());
  }

  @Test
  void theOldestIsForgottenWhenItIsTooOld() {
    Archive archive = inMemory(1 << 20, Duration.ofSeconds(60));
    archive.begin(START, 0, 20);
    fill(archive, 1, 500);

    assertThat(archive.span().orElseThrow().from())
        .isBetween(START.plusSeconds(400), START.plusSeconds(440));
  }

  @Test
  void whatIsOnTheDiskIsThereAfterARestartAndThenNobodyKnewAnything() throws IOException {
    try (Archive archive = onDisk(Disk.real())) {
      archive.read();
      archive.begin(START, 0, 20);
      fill(archive, 1, 30);
    }
    try (Archive archive = onDisk(Disk.real())) {
      archive.read();
      archive.begin(START.plusSeconds(100), 0, 20);

      assertThat(at(archive, 20).at("/facts/0/value").asInt()).isEqualTo(20);
      assertThat(at(archive, 40).path("recorded").asBoolean()).isTrue();
      assertThat(at(archive, 90).path("recorded").asBoolean()).isFalse();
      assertThat(at(archive, 100).path("facts")).isEmpty();
      List<Sample> samples = archive.samples(List.of("(level lamp)")).get("(level lamp)");
      assertThat(samples.get(samples.size() - 1).isKnown()).isFalse();
      assertThat(samples.get(samples.size() - 1).at())
          .isEqualTo(START.plusSeconds(29).toEpochMilli());
    }
  }

  @Test
  void filesAreBegunAnewAndTheOldestAreDeleted() throws IOException {
    try (Archive archive = onDisk(Disk.real())) {
      archive.begin(START, 0, 20);
      fill(archive, 1, 1_000);
    }

    List<Path> files = files();
    assertThat(files).hasSizeGreaterThan(3);
    long bytes = 0;
    for (Path file : files) {
      bytes += Files.size(file);
      assertThat(Files.readAllLines(file).get(0)).contains("\"kind\":\"state\"");
    }
    assertThat(bytes).isLessThan(30_000);
    assertThat(directory.resolve("history-000000001.jsonl")).doesNotExist();
  }

  private List<Path> files() throws IOException {
    try (Stream<Path> all = Files.list(directory)) {
      return all.sorted().toList();
    }
  }

  @Test
  void aLastLineThatIsTornIsLeftOut() throws IOException {
    try (Archive archive = onDisk(Disk.real())) {
      archive.begin(START, 0, 20);
      fill(archive, 1, 5);
    }
    Path file = files().get(0);
    byte[] all = Files.readAllBytes(file);
    for (int cut : new int[] {1, 2, 3, 20, 39}) {
      Files.write(file, Arrays.copyOf(all, all.length - cut));
      Archive archive = onDisk(Disk.real());
      archive.read();

      int last = cut == 1 ? 4 : 3;
      assertThat(at(archive, 9).at("/facts/0/value").asInt()).as("%d", cut).isEqualTo(last);
    }
    Files.write(file, new byte[] {'\n', (byte) 0xff, 0, '{', '}'}, StandardOpenOption.APPEND);
    Archive archive = onDisk(Disk.real());
    archive.read();
    assertThat(at(archive, 9).at("/facts/0/value").asInt()).isEqualTo(3);
  }

  @Test
  void aDiskThatIsFullIsToldAndGoneOnWithWhenThereIsRoom() throws IOException {
    boolean[] full = {false};
    try (Archive archive = onDisk(disk(full, PLENTY))) {
      archive.begin(START, 0, 20);
      fill(archive, 1, 5);
      assertThat(archive.problem()).isEmpty();

      full[0] = true;
      fill(archive, 5, 100);
      archive.add(figures(100));
      assertThat(archive.problem()).hasValueSatisfying(its -> assertThat(its).contains("No space"));
      assertThat(at(archive, 99).at("/facts/0/value").asInt()).as("in memory").isEqualTo(99);

      full[0] = false;
      archive.add(figures(101));
      assertThat(archive.problem()).isEmpty();
      archive.add(level(102, 100));
    }
    Archive archive = onDisk(Disk.real());
    archive.read();
    assertThat(at(archive, 4).at("/facts/0/value").asInt()).isEqualTo(4);
    assertThat(at(archive, 80).path("recorded").asBoolean()).isFalse();
    assertThat(at(archive, 101).at("/facts/0/value").asInt()).isEqualTo(99);
    assertThat(at(archive, 104).at("/facts/0/value").asInt()).isEqualTo(100);
    assertThat(archive.samples(List.of("(level lamp)")).get("(level lamp)"))
        .as("nobody knows what was between")
        .anyMatch(sample -> !sample.isKnown());
  }

  @Test
  void whatLittleRoomThereIsIsLeftToThePlatform() throws IOException {
    long[] room = {10L << 20};
    try (Archive archive = onDisk(disk(new boolean[1], room))) {
      archive.begin(START, 0, 20);
      fill(archive, 1, 50);

      assertThat(archive.problem()).hasValueSatisfying(its -> assertThat(its).contains("64 MiB"));
      assertThat(files()).isEmpty();
      room[0] = PLENTY[0];
      archive.add(figures(50));
      assertThat(archive.problem()).isEmpty();
      assertThat(files()).hasSize(1);
    }
  }

  private static Disk disk(boolean[] full, long[] room) {
    return new Disk() {
      @Override
      public OutputStream begin(Path file) throws IOException {
        return new FullAtTimes(Disk.real().begin(file), full);
      }

      @Override
      public long room(Path directory) {
        return room[0];
      }
    };
  }

  /** Half of what is written fits in before there is no room. */
  private static final class FullAtTimes extends OutputStream {
    private final OutputStream out;
    private final boolean[] full;

    FullAtTimes(OutputStream out, boolean[] full) {
      this.out = out;
      this.full = full;
    }

    @Override
    public void write(int one) throws IOException {
      write(new byte[] {(byte) one});
    }

    @Override
    public void write(byte[] bytes) throws IOException {
      out.write(bytes, 0, full[0] ? bytes.length / 2 : bytes.length);
      if (full[0]) {
        throw new IOException("No space left on device");
      }
    }

    @Override
    public void close() throws IOException {
      out.close();
    }
  }
}
