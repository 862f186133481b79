package org.maestro.platform;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.maestro.coordination.JournalImage;
import org.maestro.coordination.JournalImage.Dated;
import org.maestro.coordination.Recovery;
import org.maestro.rats.time.Clock;

/**
 * A journal's lines on the disk: a file that only grows, until it is replaced as a whole by the
 * shortest one that says the same. One thread at a time.
 */
final class JournalDisk implements AutoCloseable {
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String NAME = "journal.jsonl";
  private static final int FORMAT = 1;
  private static final long LEAST_TO_COMPACT_BYTES = 4L << 20;
  private static final int GROWTH_TO_COMPACT = 4;
  private static final Duration ENDED_GOALS_ARE_KEPT = Duration.ofDays(7);
  private static final int MOST_ENDED_GOALS = 1000;

  /** A cancel arrives long before, or never. */
  private static final Duration CANCELS_ARE_REPEATED = Duration.ofMinutes(10);

  private final Path file;
  private final DirectoryLock lock;
  private final Clock clock;
  private final JournalCodec codec;
  private final JournalImage image;
  private final Recovery recovery;
  private FileChannel channel;
  private int lines;
  private long lengthWhenCompacted;

  private JournalDisk(
      Path file, DirectoryLock lock, Clock clock, JournalCodec codec, JournalImage image)
      throws IOException {
    this.file = file;
    this.lock = lock;
    this.clock = clock;
    this.codec = codec;
    this.image = image;
    forget();
    this.recovery = image.recovery();
    this.channel = compacted();
  }

  /**
   * Opens the journal of a directory.
   *
   * @throws PlatformStartException when a line is damaged
   */
  static JournalDisk open(Path directory, DirectoryLock lock, Clock clock, JournalCodec codec)
      throws IOException {
    Path file = file(directory);
    JournalImage image = new JournalReader(file, codec).read(Timeline.of(clock));
    return new JournalDisk(file, lock, clock, codec, image);
  }

  static Path file(Path directory) {
    return directory.resolve(NAME);
  }

  Recovery recovery() {
    return recovery;
  }

  /**
   * All of them, or none when it fails.
   *
   * @param forced whether they shall survive the machine's end, and not only the process's
   */
  void append(List<Dated> entries, boolean forced) throws IOException {
    long before = channel.size();
    int linesBefore = lines;
    try {
      StringBuilder text = new StringBuilder();
      for (Dated entry : entries) {
        text.append(JournalLine.write(++lines, codec.write(entry))).append('\n');
      }
      writeAll(channel, text.toString());
      if (forced) {
        channel.force(false);
      }
    } catch (IOException e) {
      lines = linesBefore;
      channel.truncate(before);
      throw e;
    }
    entries.forEach(image::add);
  }

  void compactWhenGrown() throws IOException {
    if (channel.size()
        > Math.max(LEAST_TO_COMPACT_BYTES, GROWTH_TO_COMPACT * lengthWhenCompacted)) {
      forget();
      FileChannel former = channel;
      channel = compacted();
      former.close();
    }
  }

  private void forget() {
    image.forgetEnded(clock.now().minus(ENDED_GOALS_ARE_KEPT), MOST_ENDED_GOALS);
    image.forgetCalledOff(clock.now().minus(CANCELS_ARE_REPEATED));
  }

  /** Whoever dies meanwhile leaves the old file or the new one. */
  private FileChannel compacted() throws IOException {
    Path next = file.resolveSibling(NAME + ".new");
    int written = 0;
    StringBuilder text = new StringBuilder();
    text.append(JournalLine.write(++written, header())).append('\n');
    for (Dated entry : image.entries()) {
      text.append(JournalLine.write(++written, codec.write(entry))).append('\n');
    }
    FileChannel replacement =
        FileChannel.open(
            next,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE);
    try {
      writeAll(replacement, text.toString());
      replacement.force(true);
      Files.move(next, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
      lock.force();
    } catch (IOException e) {
      replacement.close();
      throw e;
    }
    lines = written;
    lengthWhenCompacted = replacement.size();
    return replacement;
  }

  private ObjectNode header() {
    Timeline timeline = Timeline.of(clock);
    return JSON.createObjectNode()
        .put("event", "journal")
        .put("format", FORMAT)
        .put("since", timeline.since().toString())
        .put("speed", timeline.speed())
        .put("last_goal", image.lastGoalNumber());
  }

  /** In which the times of a journal with this first line are to be read. */
  static Timeline timeline(JsonNode header) throws JournalDamage {
    if (header.path("format").asInt() != FORMAT) {
      throw new JournalDamage("it is not of the format " + FORMAT, false);
    }
    return new Timeline(
        Instant.parse(header.path("since").asText()), header.path("speed").asDouble());
  }

  static int lastGoal(JsonNode header) {
    return header.path("last_goal").asInt();
  }

  private static void writeAll(FileChannel channel, String text) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(UTF_8));
    while (bytes.hasRemaining()) {
      channel.write(bytes);
    }
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
