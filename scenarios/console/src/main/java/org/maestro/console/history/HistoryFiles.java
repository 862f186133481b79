package org.maestro.console.history;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;

/**
 * Lines in files of one directory, that are written one after the other; the oldest are deleted
 * when all together are too large, or too old. Each begins with all that was so, and can be read
 * without those before it. Not thread-safe.
 */
final class HistoryFiles implements AutoCloseable {
  private static final String PREFIX = "history-";
  private static final String SUFFIX = ".jsonl";

  /** What is shown may be missing; the journal, on the same disk, may not. */
  private static final long LEAST_ROOM = 64L << 20;

  private static final long LOOK_BYTES = 64L << 10;

  private final Path directory;
  private final long mostBytes;
  private final Duration longest;
  private final Disk disk;
  private Optional<Current> current = Optional.empty();
  private long writtenSinceLook;

  private record Current(Path file, OutputStream out) {
    void write(String line) throws IOException {
      out.write((line + "\n").getBytes(ISO_8859_1));
    }
  }

  /**
   * @param directory made when it is not there
   * @param mostBytes of all files together, without the one that is being written
   * @param longest time for which a file is kept after it was written to
   */
  HistoryFiles(Path directory, long mostBytes, Duration longest, Disk disk) {
    this.directory = directory;
    this.mostBytes = mostBytes;
    this.longest = longest;
    this.disk = disk;
  }

  /** Reads all lines of before, oldest first. */
  void read(Consumer<String> reader) throws IOException {
    for (Path file : files()) {
      try (Stream<String> lines = Files.lines(file, ISO_8859_1)) {
        lines.forEach(reader);
      } catch (UncheckedIOException e) {
        throw new IOException(e.getCause());
      }
    }
  }

  /** Begins another file. */
  void begin(String line, Instant now) throws IOException {
    close();
    Files.createDirectories(directory);
    deleteOld(now);
    requireRoom();
    long number = files().stream().mapToLong(HistoryFiles::number).max().orElse(0) + 1;
    Path file = directory.resolve(PREFIX + "%09d".formatted(number) + SUFFIX);
    Current next = new Current(file, disk.begin(file));
    current = Optional.of(next);
    try {
      next.write(line);
    } catch (IOException e) {
      close();
      Files.deleteIfExists(file);
      throw e;
    }
  }

  /** Adds to the file that was begun; after a failure another one has to be. */
  void add(String line) throws IOException {
    if (current.isPresent()) {
      try {
        writtenSinceLook += line.length();
        if (writtenSinceLook > LOOK_BYTES) {
          requireRoom();
        }
        current.get().write(line);
      } catch (IOException e) {
        close();
        throw e;
      }
    }
  }

  private void requireRoom() throws IOException {
    writtenSinceLook = 0;
    if (disk.room(directory) < LEAST_ROOM) {
      throw new IOException("less than 64 MiB are free there, and those are for goals");
    }
  }

  private void deleteOld(Instant now) throws IOException {
    List<Path> files = files();
    long bytes = 0;
    for (int i = files.size() - 1; i >= 0; i--) {
      Path file = files.get(i);
      bytes += Files.size(file);
      if (bytes > mostBytes
          || Files.getLastModifiedTime(file).toInstant().isBefore(now.minus(longest))) {
        Files.delete(file);
      }
    }
  }

  private List<Path> files() throws IOException {
    if (!Files.isDirectory(directory)) {
      return List.of();
    }
    try (Stream<Path> all = Files.list(directory)) {
      return all.filter(file -> number(file) > 0).sorted().toList();
    }
  }

  private static long number(Path file) {
    String name = file.getFileName().toString();
    String digits =
        name.startsWith(PREFIX) && name.endsWith(SUFFIX)
            ? name.substring(PREFIX.length(), name.length() - SUFFIX.length())
            : "";
    return digits.matches("[0-9]{1,18}") ? Long.parseLong(digits) : 0;
  }

  @Override
  public void close() throws IOException {
    Optional<Current> last = current;
    current = Optional.empty();
    if (last.isPresent()) {
      last.get().out().close();
    }
  }
}
