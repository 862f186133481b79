package org.maestro.console.history;

import static java.nio.charset.StandardCharsets.ISO_8859_1;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
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

  private final Path directory;
  private final long mostBytes;
  private final Duration longest;
  private final Opener opener;
  private Optional<Current> current = Optional.empty();

  /** Begins a file that is not there yet. */
  interface Opener {
    OutputStream open(Path file) throws IOException;
  }

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
  HistoryFiles(Path directory, long mostBytes, Duration longest, Opener opener) {
    this.directory = directory;
    this.mostBytes = mostBytes;
    this.longest = longest;
    this.opener = opener;
  }

  static OutputStream onDisk(Path file) throws IOException {
    return Files.newOutputStream(file, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE);
  }

  /** Reads all lines of before, oldest first. */
  void read(Consumer<String> reader) throws IOException {
    for (Path file : files()) {
      try (Stream<String> lines = Files.lines(file, ISO_8859_1)) {
        lines.forEach(reader);
      }
    }
  }

  /** Begins another file. */
  void begin(String line, Instant now) throws IOException {
    close();
    Files.createDirectories(directory);
    deleteOld(now);
    long number = files().stream().mapToLong(HistoryFiles::number).max().orElse(0) + 1;
    Path file = directory.resolve(PREFIX + "%09d".formatted(number) + SUFFIX);
    Current next = new Current(file, opener.open(file));
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
        current.get().write(line);
      } catch (IOException e) {
        close();
        throw e;
      }
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
