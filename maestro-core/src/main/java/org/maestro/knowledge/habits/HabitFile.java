package org.maestro.knowledge.habits;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.List;
import org.maestro.storage.StorageFault;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * What was counted, a line each in a file. Where the disk refuses, that is told and counting goes
 * on: a habit that is one short is a habit still. Not safe for use by several threads.
 */
public final class HabitFile implements HabitLog {
  private static final Logger LOG = LoggerFactory.getLogger(HabitFile.class);

  private final Path file;

  /**
   * @param directory in which it is, or will be, as {@code habits.log}
   */
  public HabitFile(Path directory) {
    this(directory, "habits.log");
  }

  /**
   * The same for what somebody else counts.
   *
   * @param name of the file in the directory
   */
  public HabitFile(Path directory, String name) {
    this.file = directory.resolve(name);
  }

  @Override
  public List<String> lines() {
    try {
      return Files.exists(file) ? Files.readAllLines(file) : List.of();
    } catch (IOException e) {
      LOG.warn("Habits start anew, as {} cannot be read: {}.", file, StorageFault.words(e));
      return List.of();
    }
  }

  @Override
  public void add(String line) {
    try {
      Files.createDirectories(file.getParent());
      Files.writeString(
          file,
          line + "\n",
          StandardCharsets.UTF_8,
          StandardOpenOption.CREATE,
          StandardOpenOption.APPEND);
    } catch (IOException e) {
      LOG.warn("A habit is not kept in {}: {}.", file, StorageFault.words(e));
    }
  }
}
