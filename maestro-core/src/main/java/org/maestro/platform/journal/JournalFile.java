package org.maestro.platform.journal;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalLong;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import java.util.concurrent.ThreadPoolExecutor;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.Predicate;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.journal.JournalImage.Dated;
import org.maestro.platform.jade.PlatformStartException;
import org.maestro.rats.time.Clock;
import org.maestro.storage.StorageFault;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The journal as a file of JSON lines. A thread of its own writes what has come together meanwhile
 * and forces it to the disk once for all who wait (on a stepped clock the caller does so). While
 * the disk takes nothing, what waits for it waits, and new goals are refused.
 *
 * <p>Any thread may use it. Actions run on threads of the journal and must hand over at once.
 */
public final class JournalFile implements Journal, AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(JournalFile.class);
  private static final Duration BETWEEN_TRIES = Duration.ofSeconds(1);
  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final long END_LIMIT_SECONDS = 5;

  private final Path directory;
  private final DirectoryLock lock;
  private final Clock clock;
  private final JournalDisk disk;
  private final Duration patience;
  private final Optional<Threads> threads;

  /** Guarded by this. */
  private List<Item> pending = new ArrayList<>();

  /** Guarded by this. */
  private boolean flushIsDue;

  /** Guarded by this. */
  private boolean closed;

  /** What could not be written yet; the writing thread's. */
  private List<Item> unwritten = new ArrayList<>();

  /** The writing thread's. */
  private boolean failing;

  /** Set by the writing thread. */
  private volatile Optional<String> failure = Optional.empty();

  /** Wall time at which what is being written was begun to be; set by the writing thread. */
  private volatile OptionalLong writingSinceNanos = OptionalLong.empty();

  /**
   * An item in the queue of the journal: an entry, an action that waits for those before it, or a
   * goal to be taken on.
   */
  private sealed interface Item {}

  private record Entry(Dated dated) implements Item {}

  private record Afterwards(Runnable action) implements Item {}

  /** A goal that is taken on when it is written down in time, and refused when not. */
  private final class Admission implements Item {
    private final Dated goal;
    private final Runnable accepted;
    private final Consumer<String> refused;
    private boolean isAnswered;

    private Admission(Dated goal, Runnable accepted, Consumer<String> refused) {
      this.goal = goal;
      this.accepted = accepted;
      this.refused = refused;
    }

    private synchronized boolean answer() {
      boolean first = !isAnswered;
      isAnswered = true;
      return first;
    }

    private void written() {
      if (answer()) {
        accepted.run();
      } else {
        write(new JournalEntry.Withdrawn(((JournalEntry.Submitted) goal.entry()).goalId()));
      }
    }

    private void refuse(String because) {
      if (answer()) {
        refused.accept(
            "The goal is not taken on, because the journal in %s cannot be written: %s. See to it, and state the goal again."
                .formatted(directory, because));
      }
    }
  }

  /**
   * @param writer writes
   * @param watch sees who waits too long for it
   */
  private record Threads(ScheduledThreadPoolExecutor writer, ScheduledThreadPoolExecutor watch) {
    static Threads begin() {
      ScheduledThreadPoolExecutor watch = thread("maestro-journal-watch");
      watch.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
      return new Threads(thread("maestro-journal"), watch);
    }

    private static ScheduledThreadPoolExecutor thread(String name) {
      return new ScheduledThreadPoolExecutor(
          1,
          work -> {
            Thread thread = new Thread(work, name);
            thread.setDaemon(true);
            return thread;
          },
          new ThreadPoolExecutor.DiscardPolicy());
    }
  }

  private JournalFile(
      Path directory, DirectoryLock lock, Clock clock, JournalDisk disk, Duration patience) {
    this.directory = directory;
    this.lock = lock;
    this.clock = clock;
    this.disk = disk;
    this.patience = patience;
    this.threads = clock.isStepped() ? Optional.empty() : Optional.of(Threads.begin());
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
    return open(directory, clock, fluents, PATIENCE);
  }

  /**
   * @param patience wall time that a goal waits for being written down
   */
  public static JournalFile open(
      Path directory, Clock clock, Predicate<String> fluents, Duration patience) {
    DirectoryLock lock = DirectoryLock.take(directory);
    try {
      JournalDisk disk = JournalDisk.open(directory, lock, clock, new JournalCodec(fluents));
      return new JournalFile(directory, lock, clock, disk, patience);
    } catch (IOException e) {
      lock.close();
      throw new PlatformStartException(
          "The journal %s cannot be read or written (%s); mend that, or name another directory."
              .formatted(JournalDisk.file(directory), StorageFault.words(e)),
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

  /** Why goals are not taken on now; empty when they are, as far as was tried. */
  public Optional<String> impediment() {
    OptionalLong since = writingSinceNanos;
    boolean stalls =
        since.isPresent() && System.nanoTime() - since.getAsLong() > patience.toNanos();
    return (stalls ? Optional.of(late()) : failure)
        .map(
            because ->
                "The journal in %s cannot be written: %s. Goals are refused until it can."
                    .formatted(directory, because));
  }

  private String late() {
    return "the disk has not taken it within "
        + JournalCodec.seconds(patience).stripTrailingZeros().toPlainString()
        + " s";
  }

  @Override
  public void write(JournalEntry entry) {
    if (added(new Entry(new Dated(clock.now(), entry)))) {
      threads.ifPresent(this::flushSoon);
    }
  }

  @Override
  public void afterwards(Runnable action) {
    if (added(new Afterwards(action))) {
      threads.ifPresentOrElse(this::flushSoon, this::flush);
    }
  }

  @Override
  public void accept(JournalEntry.Submitted goal, Runnable accepted, Consumer<String> refused) {
    Admission admission = new Admission(new Dated(clock.now(), goal), accepted, refused);
    if (!added(admission)) {
      admission.refuse("it was closed");
      return;
    }
    threads.ifPresentOrElse(
        own -> {
          flushSoon(own);
          Future<?> unusedAsWhatIsAnsweredIsNotRefused =
              own.watch()
                  .schedule(
                      () -> admission.refuse(late()), patience.toMillis(), TimeUnit.MILLISECONDS);
        },
        this::flush);
  }

  private synchronized boolean added(Item item) {
    if (!closed) {
      pending.add(item);
    }
    return !closed;
  }

  private void flushSoon(Threads own) {
    synchronized (this) {
      if (flushIsDue || own.writer().isShutdown()) {
        return;
      }
      flushIsDue = true;
    }
    own.writer().execute(this::flush);
  }

  private void flush() {
    synchronized (this) {
      flushIsDue = false;
      unwritten.addAll(pending);
      pending = new ArrayList<>();
    }
    writingSinceNanos = OptionalLong.of(System.nanoTime());
    try {
      if (failing) {
        writeWhatWaited();
      }
      List<Item> items = unwritten;
      write(items);
      unwritten = new ArrayList<>();
      items.forEach(this::written);
      disk.compactWhenGrown();
    } catch (IOException e) {
      failed(StorageFault.words(e));
    } catch (PlatformStartException e) {
      failed(Objects.requireNonNullElse(e.getMessage(), e.toString()));
    } catch (RuntimeException e) {
      LOG.error("The journal in {} could not be written", directory, e);
    } finally {
      writingSinceNanos = OptionalLong.empty();
    }
  }

  /** First, so that nothing new is written on a disk that refuses it after all. */
  private void writeWhatWaited() throws IOException {
    List<Item> waited = unwritten.stream().filter(i -> !(i instanceof Admission)).toList();
    List<Item> admissions = unwritten.stream().filter(Admission.class::isInstance).toList();
    write(waited);
    unwritten = new ArrayList<>(admissions);
    failing = false;
    failure = Optional.empty();
    LOG.warn("The journal in {} can be written again.", directory);
    waited.forEach(this::written);
  }

  /** All of them or none. */
  private void write(List<Item> items) throws IOException {
    List<Dated> entries = new ArrayList<>();
    boolean forced = false;
    for (Item item : items) {
      if (item instanceof Entry entry) {
        entries.add(entry.dated());
      } else if (item instanceof Admission admission) {
        entries.add(admission.goal);
      }
      forced |= !(item instanceof Entry);
    }
    disk.append(entries, forced);
  }

  private void written(Item item) {
    if (isClosed()) {
      return;
    }
    if (item instanceof Afterwards afterwards) {
      afterwards.action().run();
    } else if (item instanceof Admission admission) {
      admission.written();
    }
  }

  /** What waits goes on waiting, for it may not happen before it is written. */
  private void failed(String because) {
    if (!failing) {
      LOG.error(
          "The journal in {} cannot be written: {}. New goals are refused and no step is begun"
              + " until it can; what runs goes on.",
          directory,
          because);
    }
    failing = true;
    failure = Optional.of(because);
    List<Item> tried = unwritten;
    unwritten = new ArrayList<>(tried.stream().filter(i -> !(i instanceof Admission)).toList());
    for (Item item : tried) {
      if (item instanceof Admission admission) {
        admission.refuse(because);
      }
    }
    if (!isClosed()) {
      tryAgain();
    }
  }

  private synchronized boolean isClosed() {
    return closed;
  }

  private void tryAgain() {
    threads.ifPresentOrElse(
        own -> {
          synchronized (this) {
            flushIsDue = true;
          }
          Future<?> unusedAsFlushTellsWhatFails =
              own.writer().schedule(this::flush, BETWEEN_TRIES.toMillis(), TimeUnit.MILLISECONDS);
        },
        () -> clock.schedule(BETWEEN_TRIES, "journal", this::flush));
  }

  /** Writes what is left. Actions that wait still are not run, nor any that come later. */
  @Override
  public void close() {
    synchronized (this) {
      if (closed) {
        return;
      }
      closed = true;
      pending.removeIf(item -> !(item instanceof Entry));
    }
    threads.ifPresentOrElse(this::end, this::flush);
    try {
      disk.close();
    } catch (IOException e) {
      LOG.error("The journal in {} could not be closed", directory, e);
    }
    lock.close();
  }

  private void end(Threads own) {
    own.watch().shutdown();
    own.writer().execute(this::flush);
    own.writer().shutdown();
    try {
      if (!own.writer().awaitTermination(END_LIMIT_SECONDS, TimeUnit.SECONDS)) {
        LOG.error("The journal in {} could not be written to its end", directory);
        own.writer().shutdownNow();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
