package org.maestro.rats.security;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.attribute.BasicFileAttributes;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;

/**
 * Files that are read while a site runs, and read again when they have changed, so that nothing has
 * to be started again. Thread-safe.
 */
public final class WatchedFiles {
  /** Two changes within the grain of a file system's clock may leave the same date. */
  private static final Duration GRAIN = Duration.ofSeconds(2);

  private final List<Path> files;
  private List<Stamp> seen;

  private record Stamp(Instant changedAt, long bytes, Object key, int hash) {
    private boolean isSurelyThat(Stamp other) {
      return changedAt.equals(other.changedAt)
          && bytes == other.bytes
          && String.valueOf(key).equals(String.valueOf(other.key))
          && Duration.between(changedAt, Instant.now()).compareTo(GRAIN) > 0;
    }
  }

  /** Those files as they are now; they are to be read after this. */
  public WatchedFiles(List<Path> files) {
    this.files = List.copyOf(files);
    this.seen = stamps();
  }

  /** Whether one has changed, come or gone since this was made, or last said so. */
  public synchronized boolean haveChanged() {
    if (areSurelyThose()) {
      return false;
    }
    List<Stamp> now = stamps();
    boolean changed = !now.equals(seen);
    seen = now;
    return changed;
  }

  private boolean areSurelyThose() {
    for (int file = 0; file < files.size(); file++) {
      if (!stamp(files.get(file), false).isSurelyThat(seen.get(file))) {
        return false;
      }
    }
    return true;
  }

  private List<Stamp> stamps() {
    return files.stream().map(file -> stamp(file, true)).toList();
  }

  /** A file that is not there has a stamp too, so that its coming back is noticed. */
  private static Stamp stamp(Path file, boolean withContent) {
    try {
      BasicFileAttributes attributes = Files.readAttributes(file, BasicFileAttributes.class);
      return new Stamp(
          attributes.lastModifiedTime().toInstant(),
          attributes.size(),
          attributes.fileKey(),
          withContent ? Arrays.hashCode(Files.readAllBytes(file)) : 0);
    } catch (IOException missing) {
      return new Stamp(Instant.EPOCH, 0, "", 0);
    }
  }
}
