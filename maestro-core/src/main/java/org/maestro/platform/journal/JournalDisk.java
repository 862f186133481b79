package org.maestro.platform.journal;

import static java.nio.charset.StandardCharsets.UTF_8;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Objects;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.journal.JournalImage;
import org.maestro.coordination.journal.JournalImage.Dated;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.time.Clock;
import org.maestro.storage.StorageFault;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * A journal's lines on the disk: a file that only grows, until it is replaced as a whole by the
 * shortest one that says the same. After a failure nobody knows what of the file is there (what a
 * disk did not take when it was forced may be forgotten): it is replaced as a whole then, too. One
 * thread at a time.
 */
final class JournalDisk implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(JournalDisk.class);
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final String NAME = "journal.jsonl";
  private static final int FORMAT = 1;
  private static final long LEAST_TO_COMPACT_BYTES = 4L << 20;
  private static final int GROWTH_TO_COMPACT = 4;
  private static final Duration ENDED_GOALS_ARE_KEPT = Duration.ofDays(7);
  private static final long MOST_BYTES_OF_ENDED_GOALS = 1 << 20;

  /** A cancel arrives long before, or never. */
  private static final Duration CANCELS_ARE_REPEATED = Duration.ofMinutes(10);

  private final Path file;
  private final DirectoryLock lock;
  private final Clock clock;
  private final JournalCodec codec;
  private final JournalImage image;
  private final Recovery recovery;
  private Written written;
  private long compactedFromBytes;
  private boolean uncertain;

  /**
   * The file as it is to be.
   *
   * @param key by which the system tells it from another of its name
   * @param mark of its last line
   * @param certain the same of the last line that was forced
   */
  private record Written(
      FileChannel channel, Object key, long bytes, JournalMark mark, JournalMark certain) {}

  private JournalDisk(
      Path file, DirectoryLock lock, Clock clock, JournalCodec codec, JournalReader.Found found)
      throws IOException {
    this.file = file;
    this.lock = lock;
    this.clock = clock;
    this.codec = codec;
    this.image = found.image();
    forget();
    this.recovery = image.recovery();
    this.written = put(linesOfAll(found.generation() + 1));
    settle();
  }

  /**
   * Opens the journal of a directory.
   *
   * @throws PlatformStartException when a line is damaged
   */
  static JournalDisk open(Path directory, DirectoryLock lock, Clock clock, JournalCodec codec)
      throws IOException {
    Path file = file(directory);
    JournalReader.Found found = new JournalReader(file, codec).read(Timeline.of(clock));
    return new JournalDisk(file, lock, clock, codec, found);
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
    if (uncertain) {
      replace(written.mark().generation() + 1);
    }
    Lines lines = new Lines(written.mark());
    entries.forEach(entry -> lines.add(codec.write(entry)));
    uncertain = true;
    try {
      written = appended(written, lines, forced);
    } catch (IOException e) {
      cutOff(e);
      throw e;
    }
    uncertain = false;
    entries.forEach(image::add);
    if (entries.stream().anyMatch(dated -> dated.entry() instanceof JournalEntry.Over)) {
      forget();
    }
  }

  private Written appended(Written before, Lines lines, boolean forced) throws IOException {
    writeAll(before.channel(), lines.bytes());
    Written after =
        new Written(
            before.channel(),
            before.key(),
            before.bytes() + lines.bytes().length,
            lines.mark(),
            forced ? lines.mark() : before.certain());
    if (forced) {
      after.channel().force(false);
      requireThere(after);
      after.certain().write(file);
    }
    return after;
  }

  /** Somebody may have removed it, cut it, or put another in its place. */
  private void requireThere(Written file) throws IOException {
    BasicFileAttributes found = Files.readAttributes(this.file, BasicFileAttributes.class);
    if (!Objects.equals(found.fileKey(), file.key()) || found.size() != file.bytes()) {
      throw new FileSystemException(
          this.file.toString(), null, "somebody else has changed or replaced it");
    }
  }

  /** So that who reads it after this process's death finds what was there before, and no more. */
  private void cutOff(IOException failure) {
    try {
      written.channel().truncate(written.bytes());
      written.certain().write(file);
    } catch (IOException e) {
      failure.addSuppressed(e);
    }
  }

  /** When it cannot be done now, it is tried again when the file has grown by as much. */
  void compactWhenGrown() {
    if (written.bytes() <= compactedFromBytes) {
      return;
    }
    forget();
    try {
      replace(written.mark().generation() + 1);
    } catch (IOException e) {
      compactedFromBytes += LEAST_TO_COMPACT_BYTES;
      LOG.warn("The journal {} cannot be shortened now: {}", file, StorageFault.words(e));
    }
  }

  private void forget() {
    image.forgetEnded(clock.now().minus(ENDED_GOALS_ARE_KEPT), MOST_BYTES_OF_ENDED_GOALS);
    image.forgetCalledOff(clock.now().minus(CANCELS_ARE_REPEATED));
  }

  private void replace(int generation) throws IOException {
    lock.keep();
    Written replaced = written;
    written = put(linesOfAll(generation));
    replaced.channel().close();
    settle();
  }

  private Lines linesOfAll(int generation) {
    Lines lines = new Lines(new JournalMark(generation, 0, ""));
    lines.add(header(generation));
    image.entries().forEach(entry -> lines.add(codec.write(entry)));
    return lines;
  }

  /** Whoever dies meanwhile leaves the old file or the new one. */
  private Written put(Lines lines) throws IOException {
    Path next = file.resolveSibling(NAME + ".new");
    FileChannel replacement =
        FileChannel.open(
            next,
            StandardOpenOption.CREATE,
            StandardOpenOption.TRUNCATE_EXISTING,
            StandardOpenOption.WRITE);
    try {
      writeAll(replacement, lines.bytes());
      replacement.force(true);
      Object key = Files.readAttributes(next, BasicFileAttributes.class).fileKey();
      Files.move(next, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
      return new Written(replacement, key, lines.bytes().length, lines.mark(), lines.mark());
    } catch (IOException e) {
      giveUp(replacement, next, e);
      throw e;
    }
  }

  /** Makes certain what was put in the place of all. */
  private void settle() throws IOException {
    compactedFromBytes = Math.max(LEAST_TO_COMPACT_BYTES, GROWTH_TO_COMPACT * written.bytes());
    uncertain = true;
    lock.force();
    written.certain().write(file);
    uncertain = false;
  }

  /** Half a file would take the room that others wait for. */
  private static void giveUp(FileChannel replacement, Path next, IOException failure) {
    try {
      replacement.close();
      Files.deleteIfExists(next);
    } catch (IOException e) {
      failure.addSuppressed(e);
    }
  }

  private ObjectNode header(int generation) {
    Timeline timeline = Timeline.of(clock);
    ObjectNode header =
        JSON.createObjectNode()
            .put("event", "journal")
            .put("format", FORMAT)
            .put("since", timeline.since().toString())
            .put("speed", timeline.speed())
            .put("last_goal", image.lastGoalNumber());
    return JournalMark.generation(header, generation);
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

  private static void writeAll(FileChannel channel, byte[] text) throws IOException {
    ByteBuffer bytes = ByteBuffer.wrap(text);
    while (bytes.hasRemaining()) {
      channel.write(bytes);
    }
  }

  @Override
  public void close() throws IOException {
    written.channel().close();
  }

  /** Lines that follow others. */
  private static final class Lines {
    private final StringBuilder text = new StringBuilder();
    private JournalMark mark;

    private Lines(JournalMark before) {
      this.mark = before;
    }

    private void add(ObjectNode fields) {
      String line = JournalLine.write(mark.lines() + 1, mark.checksum(), fields);
      text.append(line).append('\n');
      mark = new JournalMark(mark.generation(), mark.lines() + 1, JournalLine.checksumOf(line));
    }

    private byte[] bytes() {
      return text.toString().getBytes(UTF_8);
    }

    private JournalMark mark() {
      return mark;
    }
  }
}
