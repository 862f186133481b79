package org.maestro.platform;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;

/**
 * The right to act for a site, which one process has at a time of those that share its data
 * directory. The system takes it back when the process dies, and gives it at once to one that
 * stands by. A frozen process keeps it.
 */
public final class Duty implements AutoCloseable {
  private static final String NAME = "duty";

  private final FileChannel channel;

  private Duty(FileChannel channel) {
    this.channel = channel;
  }

  /**
   * Takes it, or tells that somebody else has it.
   *
   * @throws PlatformStartException when the directory cannot be used
   */
  public static Optional<Duty> tryToTake(Path directory) {
    FileChannel channel = open(directory);
    try {
      FileLock lock = channel.tryLock();
      if (lock != null) {
        return Optional.of(new Duty(channel));
      }
    } catch (OverlappingFileLockException e) {
      // Another platform of this process has it.
    } catch (IOException e) {
      throw unusable(directory, e);
    }
    close(channel);
    return Optional.empty();
  }

  /**
   * Takes it as soon as nobody else has it. Blocks until then.
   *
   * @throws PlatformStartException when the directory cannot be used
   */
  public static Duty await(Path directory) {
    FileChannel channel = open(directory);
    try {
      channel.lock();
      return new Duty(channel);
    } catch (IOException | OverlappingFileLockException e) {
      close(channel);
      throw unusable(directory, e);
    }
  }

  private static FileChannel open(Path directory) {
    try {
      Files.createDirectories(directory);
      return FileChannel.open(
          directory.resolve(NAME), StandardOpenOption.CREATE, StandardOpenOption.WRITE);
    } catch (IOException e) {
      throw unusable(directory, e);
    }
  }

  private static PlatformStartException unusable(Path directory, Exception e) {
    return new PlatformStartException(
        "The directory %s cannot be used (%s); name one that can be written."
            .formatted(directory, e.getMessage()),
        e);
  }

  private static void close(FileChannel channel) {
    try {
      channel.close();
    } catch (IOException e) {
      throw new UncheckedIOException("A data directory cannot be let go", e);
    }
  }

  @Override
  public void close() {
    close(channel);
  }
}
