package org.maestro.platform;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import org.maestro.coordination.Journal;
import org.maestro.coordination.JournalEntry;
import org.maestro.coordination.JournalImage.Dated;
import org.maestro.coordination.Recovery;
import org.maestro.rats.time.Clock;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The journal as a file of JSON lines. A thread of its own writes what has come together meanwhile
 * and forces it to the disk once for all who wait (on a stepped clock the caller does so). While
 * the disk takes nothing, what waits for it waits.
 *
 * <p>Any thread may use it. Actions run on the writing thread and must hand over at once.
 */
public final class JournalFile implements Journal, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(JournalFile.class);
  private static final long RETRY_MILLIS = 1_000;
  private static final long END_LIMIT_SECONDS = 5;

  private final Path directory;
  private final DirectoryLock lock;
  private final Clock clock;
  private final JournalDisk disk;
  private final Optional<ScheduledThreadPoolExecutor> writer;

  /** Guarded by this. */
  private List<Dated> pending = new ArrayList<>();

  /** Guarded by this. */
  private List<Runnable> waiting = new ArrayList<>();

  /** Guarded by this. */
  private boolean flushIsDue;

  /** Guarded by this. */
  private boolean closed;

  /** The writing thread's. */
  private List<Dated> unwritten = new ArrayList<>();

  /** The writing thread's. */
  private boolean failing;

  private JournalFile(Path directory, DirectoryLock lock, Clock clock, JournalDisk disk) {
    this.directory = directory;
    this.lock = lock;
    this.clock = clock;
    this.disk = disk;
    this.writer =
        clock.isStepped()
            ? Optional.empty()
            : Optional.of(new ScheduledThreadPoolExecutor(1, JournalFile::thread));
  }

  /**
   * Opens the journal of a directory, which is made when it is not there. A last line that was cut
   * short by the death of its writer is left away.
   *
   * @param fluents which predicates have numbers as values
   * @throws PlatformStartException when another process uses the directory, the journal is damaged,
   *     or it cannot be read or written
   */
  public static JournalFile open(Path directory, Clock clock, Predicate<String> fluents) {
    DirectoryLock lock = DirectoryLock.take(directory);
    try {
      JournalDisk disk = JournalDisk.open(directory, lock, clock, new JournalCodec(fluents));
      return new JournalFile(directory, lock, clock, disk);
    } catch (IOException e) {
      lock.close();
      throw new PlatformStartException(
          "The journal %s cannot be read or written (%s); mend that, or name another directory."
              .formatted(JournalDisk.file(directory), e.getMessage()),
          e);
    } catch (PlatformStartException e) {
      lock.close();
      throw e;
    }
  }

  /** What was found when it was opened. */
  public Recovery recovery() {
    return disk.recovery();
  }

  @Override
  public void write(JournalEntry entry) {
    Dated dated = new Dated(clock.now(), entry);
    synchronized (this) {
      if (closed) {
        return;
      }
      pending.add(dated);
    }
    writer.ifPresent(this::flushSoon);
  }

  @Override
  public void afterwards(Runnable action) {
    synchronized (this) {
      if (closed) {
        return;
      }
      waiting.add(action);
    }
    writer.ifPresentOrElse(this::flushSoon, this::flush);
  }

  private void flushSoon(ScheduledThreadPoolExecutor thread) {
    synchronized (this) {
      if (flushIsDue || thread.isShutdown()) {
        return;
      }
      flushIsDue = true;
    }
    thread.execute(this::flush);
  }

  private void flush() {
    List<Runnable> actions;
    synchronized (this) {
      flushIsDue = false;
      unwritten.addAll(pending);
      pending = new ArrayList<>();
      actions = waiting;
      waiting = new ArrayList<>();
    }
    try {
      disk.append(unwritten, !actions.isEmpty());
      unwritten = new ArrayList<>();
      disk.compactWhenGrown();
      failing = false;
      actions.forEach(Runnable::run);
    } catch (IOException e) {
      failed(e, actions);
    } catch (RuntimeException e) {
      LOG.error("The journal in {} could not be written", directory, e);
    }
  }

  /** What waits goes on waiting, for it may not happen before it is written. */
  private void failed(IOException failure, List<Runnable> actions) {
    ScheduledThreadPoolExecutor thread =
        writer.orElseThrow(
            () -> new UncheckedIOException("No journal can be written in " + directory, failure));
    if (!failing) {
      LOG.error(
          "The journal in {} cannot be written ({}); nothing new begins until it can",
          directory,
          failure.getMessage());
    }
    failing = true;
    synchronized (this) {
      actions.addAll(waiting);
      waiting = actions;
      flushIsDue = true;
    }
    thread.schedule(this::flush, RETRY_MILLIS, TimeUnit.MILLISECONDS);
  }

  private static Thread thread(Runnable work) {
    Thread thread = new Thread(work, "maestro-journal");
    thread.setDaemon(true);
    return thread;
  }

  /** Writes what is left. Actions that wait still are not run, nor any that come later. */
  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
      waiting = new ArrayList<>();
    }
    writer.ifPresentOrElse(this::end, this::flush);
    try {
      disk.close();
    } catch (IOException e) {
      LOG.error("The journal in {} could not be closed", directory, e);
    }
    lock.close();
  }

  private void end(ScheduledThreadPoolExecutor thread) {
    thread.execute(this::flush);
    thread.shutdown();
    try {
      if (!thread.awaitTermination(END_LIMIT_SECONDS, TimeUnit.SECONDS)) {
        LOG.error("The journal in {} could not be written to its end", directory);
        thread.shutdownNow();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
