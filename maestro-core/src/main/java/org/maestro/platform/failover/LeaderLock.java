package org.maestro.platform.failover;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.channels.FileChannel;
import java.nio.channels.FileLock;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.locks.LockSupport;
import org.maestro.platform.jade.PlatformStartException;

/**
 * The right to act for a site, which one process has at a time of those that share its data
 * directory. The system takes it back when the process dies, and gives it to one that stands by. A
 * frozen process on the same machine is ended by who stands by.
 */
public final class LeaderLock implements AutoCloseable {
  private static final String NAME = "duty";

  private static final Duration BETWEEN_LOOKS = Duration.ofMillis(50);

  private final FileChannel channel;
  private final Runnable endOfBeat;

  private LeaderLock(FileChannel channel, Runnable endOfBeat) {
    this.channel = channel;
    this.endOfBeat = endOfBeat;
  }

  /**
   * Takes it, or tells that somebody else has it.
   *
   * @throws PlatformStartException when the directory cannot be used
   */
  public static Optional<LeaderLock> tryToTake(Path directory) {
    FileChannel channel = open(directory);
    try {
      FileLock lock = channel.tryLock();
      if (lock != null) {
        return Optional.of(new LeaderLock(channel, new LeaderHeartbeat(directory).begin()));
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
   * Takes it as soon as nobody else has it, and ends a process of this machine that has it and is
   * frozen. Blocks until then.
   *
   * @throws PlatformStartException when the directory cannot be used
   */
  public static LeaderLock await(Path directory) {
    LeaderHeartbeat others = new LeaderHeartbeat(directory);
    long before = System.nanoTime();
    while (true) {
      Optional<LeaderLock> taken = tryToTake(directory);
      if (taken.isPresent()) {
        return taken.get();
      }
      LockSupport.parkNanos(BETWEEN_LOOKS.toNanos());
      long now = System.nanoTime();
      others.look(Duration.ofNanos(now - before));
      before = now;
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
    endOfBeat.run();
    close(channel);
  }
}
