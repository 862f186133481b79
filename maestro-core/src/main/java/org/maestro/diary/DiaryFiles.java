package org.maestro.diary;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.DateTimeException;
import java.time.LocalDate;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import org.maestro.storage.StorageFault;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The files of a diary, one for each day. Days that are older than two months are deleted when a
 * new one begins. What cannot be read is left out, and that is said in the log. One thread writes;
 * any reads.
 */
final class DiaryFiles {
  private static final Logger LOG = LoggerFactory.getLogger(DiaryFiles.class);
  private static final String ENDING = ".jsonl";
  private static final int DAYS_KEPT = 62;

  private final Path directory;

  DiaryFiles(Path directory) {
    this.directory = directory;
  }

  void write(LocalDate day, String line) throws IOException {
    Path file = directory.resolve(day + ENDING);
    boolean isNew = !Files.exists(file);
    if (isNew) {
      Files.createDirectories(directory);
      deleteBefore(day.minusDays(DAYS_KEPT));
    }
    // A line that was cut short ends here: an empty line between two is none.
    Files.writeString(
        file,
        (isNew ? "" : "\n") + line + "\n",
        StandardCharsets.UTF_8,
        StandardOpenOption.CREATE,
        StandardOpenOption.APPEND);
  }

  private void deleteBefore(LocalDate first) throws IOException {
    for (LocalDate day : days()) {
      if (day.isBefore(first)) {
        Files.delete(directory.resolve(day + ENDING));
      }
    }
  }

  private List<LocalDate> days() throws IOException {
    try (Stream<Path> files = Files.list(directory)) {
      return files
          .map(file -> file.getFileName().toString())
          .filter(name -> name.endsWith(ENDING))
          .flatMap(name -> day(name.substring(0, name.length() - ENDING.length())).stream())
          .sorted()
          .toList();
    }
  }

  private static Optional<LocalDate> day(String text) {
    try {
      return Optional.of(LocalDate.parse(text));
    } catch (DateTimeException other) {
      return Optional.empty();
    }
  }

  /** The lines of a day, oldest first; none where there is no such day. */
  List<DiaryLine> read(LocalDate day) {
    Path file = directory.resolve(day + ENDING);
    if (!Files.exists(file)) {
      return List.of();
    }
    try {
      String text = new String(Files.readAllBytes(file), StandardCharsets.UTF_8);
      List<String> lines = text.lines().filter(line -> !line.isBlank()).toList();
      List<DiaryLine> read = lines.stream().flatMap(line -> LineCodec.read(line).stream()).toList();
      if (read.size() < lines.size()) {
        LOG.warn("{} lines of {} are damaged and left out.", lines.size() - read.size(), file);
      }
      return read;
    } catch (IOException e) {
      LOG.warn("The day {} is left out, as it cannot be read: {}.", day, StorageFault.words(e));
      return List.of();
    }
  }
}
