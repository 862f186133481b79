package org.maestro.knowledge.api;

import java.nio.file.Path;
import java.time.Duration;
import java.util.Optional;

/**
 * The retention of the past: how much of it is kept, and where.
 *
 * @param kept how long statements are kept; what is known now is kept however old it is
 * @param mostOfEach statements kept of one state variable, so that a stream of positions cannot
 *     fill the memory
 * @param mostBytes of memory for all statements that were followed by others; the oldest go first
 * @param directory where statements are written, to be read again after a restart; empty: they end
 *     with the process, or with the store
 * @param store where the dataset is kept
 */
public record KnowledgeSettings(
    Duration kept, int mostOfEach, long mostBytes, Optional<Path> directory, Store store) {

  private static final Duration A_DAY = Duration.ofDays(1);
  private static final int MOST_OF_EACH = 200;
  private static final long MOST_BYTES = 4L << 20;

  public KnowledgeSettings {
    if (kept.isNegative() || mostOfEach < 1 || mostBytes < 0) {
      throw new IllegalArgumentException(
          "History is kept for "
              + kept
              + " and "
              + mostOfEach
              + " statements of each, in "
              + mostBytes
              + " bytes; give a time from 0, a number from 1 and bytes from 0.");
    }
  }

  /** With the dataset in memory. */
  public KnowledgeSettings(Duration kept, int mostOfEach, Optional<Path> directory) {
    this(kept, mostOfEach, MOST_BYTES, directory, Store.IN_MEMORY);
  }

  /** A day, in memory. */
  public static KnowledgeSettings inMemory() {
    return new KnowledgeSettings(A_DAY, MOST_OF_EACH, Optional.empty());
  }

  /** A day, also on disk; the directory is made when it is not there. */
  public static KnowledgeSettings in(Path directory) {
    return new KnowledgeSettings(A_DAY, MOST_OF_EACH, Optional.of(directory));
  }

  /** The same with the dataset elsewhere. */
  public KnowledgeSettings with(Store other) {
    return new KnowledgeSettings(kept, mostOfEach, mostBytes, directory, other);
  }

  /** The same with more or less memory for what was said before. */
  public KnowledgeSettings with(long otherBytes) {
    return new KnowledgeSettings(kept, mostOfEach, otherBytes, directory, store);
  }
}
