package org.maestro.knowledge.history;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStreamReader;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.time.Instant;
import java.time.format.DateTimeParseException;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.knowledge.api.Source;
import org.maestro.knowledge.belief.FactReader;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;
import org.maestro.storage.StorageFault;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Statements on disk, one a line, in files that are written one after the other and deleted when
 * all in them is too old. A line is whole or it is left out: a process that is killed loses at most
 * the line that it was writing. Not thread-safe.
 */
public final class HistoryFile implements AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(HistoryFile.class);
  private static final String PREFIX = "history-";
  private static final String SUFFIX = ".txt";
  private static final int LINES_PER_FILE = 20_000;
  private static final int FIELDS = 6;

  private final Path directory;
  private final Duration kept;
  private Optional<Writer> writer = Optional.empty();
  private int lines;

  /** A statement as it is written. */
  public record Line(Belief belief, boolean believed) {}

  public HistoryFile(Path directory, Duration kept) {
    this.directory = directory;
    this.kept = kept;
  }

  /**
   * Reads what was written before, oldest first.
   *
   * @throws KnowledgeException when the directory cannot be made or read
   */
  public void read(Instant now, Consumer<Line> reader) {
    int unreadable = 0;
    try {
      Files.createDirectories(directory);
      deleteOld(now);
      for (Path file : files()) {
        String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
        for (String line : text.split("\n")) {
          Optional<Line> read = line.isEmpty() ? Optional.empty() : parsed(line, now);
          read.ifPresent(reader);
          unreadable += line.isEmpty() || read.isPresent() ? 0 : 1;
        }
      }
    } catch (IOException e) {
      throw new KnowledgeException(
          "The history in "
              + directory
              + " cannot be read: "
              + e.getMessage()
              + ". Make the directory readable, or choose another.",
          e);
    }
    if (unreadable > 0) {
      LOG.warn("{} lines of the history in {} are damaged and left out.", unreadable, directory);
    }
  }

  /**
   * Writes one statement, and hands it over to the operating system, so that a kill does not lose
   * it. After a failure another file is begun.
   */
  public void write(Line line, Instant now) throws IOException {
    if (writer.isEmpty() || lines >= LINES_PER_FILE) {
      next(now);
    }
    try {
      writer.orElseThrow().write(text(line));
      writer.orElseThrow().flush();
      lines++;
    } catch (IOException e) {
      giveUp(e);
      throw e;
    }
  }

  private void giveUp(IOException failure) {
    try {
      writer.orElseThrow().close();
    } catch (IOException e) {
      failure.addSuppressed(e);
    }
    writer = Optional.empty();
  }

  private void next(Instant now) throws IOException {
    if (writer.isPresent()) {
      writer.get().close();
    }
    deleteOld(now);
    long number = files().stream().mapToLong(HistoryFile::number).max().orElse(0) + 1;
    Path file = directory.resolve(PREFIX + "%09d".formatted(number) + SUFFIX);
    writer =
        Optional.of(
            Files.newBufferedWriter(
                file,
                StandardCharsets.UTF_8,
                StandardOpenOption.CREATE,
                StandardOpenOption.APPEND));
    lines = 0;
  }

  /** A file ends where the next one begins: all in it is as old as that or older. */
  private void deleteOld(Instant now) throws IOException {
    List<Path> files = files();
    for (int i = 0; i + 1 < files.size(); i++) {
      if (first(files.get(i + 1), now)
          .filter(line -> line.belief().since().plus(kept).isBefore(now))
          .isEmpty()) {
        return;
      }
      Files.delete(files.get(i));
    }
  }

  private static Optional<Line> first(Path file, Instant now) throws IOException {
    try (BufferedReader reader =
        new BufferedReader(
            new InputStreamReader(Files.newInputStream(file), StandardCharsets.UTF_8))) {
      return Optional.ofNullable(reader.readLine()).flatMap(line -> parsed(line, now));
    }
  }

  private List<Path> files() throws IOException {
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

  private static String text(Line line) {
    Belief belief = line.belief();
    return String.join(
            "\t",
            belief.since().toString(),
            belief.source().kind().name().toLowerCase(Locale.ROOT),
            belief.source().agent().replaceAll("[\t\n\r]", " "),
            SlPrinter.print(new Term.Number(belief.confidence())),
            line.believed() ? "believed" : "not-believed",
            belief.fact().replace('\n', ' ').replace('\r', ' '))
        + "\n";
  }

  /** A time to come is one of another run's clock; the statement counts as received now. */
  private static Optional<Line> parsed(String line, Instant now) {
    String[] fields = line.split("\t", FIELDS);
    if (fields.length < FIELDS) {
      return Optional.empty();
    }
    try {
      Instant since = Instant.parse(fields[0]);
      Source.Kind kind = Source.Kind.valueOf(fields[1].toUpperCase(Locale.ROOT));
      FactReader.read(fields[5], fields[2]);
      return Optional.of(
          new Line(
              new Belief(
                  fields[5],
                  new Source(kind, fields[2]),
                  since.isAfter(now) ? now : since,
                  Double.parseDouble(fields[3])),
              fields[4].equals("believed")));
    } catch (DateTimeParseException | IllegalArgumentException damaged) {
      return Optional.empty();
    }
  }

  @Override
  public void close() {
    if (writer.isPresent()) {
      try {
        writer.get().close();
      } catch (IOException e) {
        LOG.warn("The history in {} could not be closed: {}", directory, StorageFault.words(e));
      }
    }
  }
}
