package org.maestro.knowledge.rdf;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import org.maestro.knowledge.api.KnowledgeException;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes to a slow storage beside those who write, many edits at once: a disk that forces each
 * transaction takes some hundred of them in a second, whatever is in them. Who reads waits until
 * all that was written before is there. A storage that fails is tried again; meanwhile edits wait,
 * and beyond a bound the oldest are given up, which is told.
 */
final class WriteBehind implements GraphStorage {
  private static final Logger LOG = LoggerFactory.getLogger(WriteBehind.class);
  private static final int MOST_AT_ONCE = 500;
  private static final long MOST_BYTES_WAITING = 32L << 20;
  private static final long MILLIS_BETWEEN_TRIES = 500;
  private static final long MILLIS_FOR_A_STORE_THAT_FAILS = 3_000;

  private final GraphStorage storage;
  private final Duration patience;
  private final Deque<Edit> waiting = new ArrayDeque<>();
  private final Thread writer = new Thread(this::write, "knowledge-store");
  private long waitingBytes;
  private int underway;

  /** Why it was not written last, a sentence; empty when it was. */
  private String failure = "";

  private boolean overflown;
  private boolean closed;

  /**
   * @param patience how long who reads or closes waits for what was written before
   */
  WriteBehind(GraphStorage storage, Duration patience) {
    this.storage = storage;
    this.patience = patience;
    writer.setDaemon(true);
  }

  /** Begins to write; to be called once. */
  WriteBehind begin() {
    writer.start();
    return this;
  }

  @Override
  public synchronized void apply(List<Edit> edits) {
    for (Edit edit : edits) {
      waitingBytes += edit.bytes();
      while (waitingBytes > MOST_BYTES_WAITING && !waiting.isEmpty()) {
        waitingBytes -= waiting.removeFirst().bytes();
        if (!overflown) {
          overflown = true;
          LOG.error("What was kept first is missing in the store, which takes nothing any more.");
        }
      }
      waiting.addLast(edit);
    }
    notifyAll();
  }

  private void write() {
    List<Edit> batch = next();
    while (!batch.isEmpty()) {
      if (written(batch)) {
        done();
        batch = next();
      } else if (!pause()) {
        return;
      }
    }
  }

  /** Waits for something to write; empty when it is over. */
  private synchronized List<Edit> next() {
    while (waiting.isEmpty() && !closed) {
      if (!waited(0)) {
        return List.of();
      }
    }
    List<Edit> batch = new ArrayList<>();
    while (!waiting.isEmpty() && batch.size() < MOST_AT_ONCE) {
      Edit edit = waiting.removeFirst();
      waitingBytes -= edit.bytes();
      batch.add(edit);
    }
    underway = batch.size();
    return batch;
  }

  private boolean written(List<Edit> batch) {
    try {
      storage.apply(batch);
      if (!failed("").isEmpty()) {
        LOG.warn("The store takes again what is to be kept.");
      }
      return true;
    } catch (RuntimeException e) {
      String why = Objects.requireNonNullElse(e.getMessage(), e.toString());
      if (failed(why).isEmpty()) {
        LOG.error("{} What is said meanwhile is kept aside, and it is tried again.", why);
      }
      return false;
    }
  }

  /** Returns what it was before. */
  private synchronized String failed(String because) {
    String before = failure;
    failure = because;
    notifyAll();
    return before;
  }

  private synchronized void done() {
    underway = 0;
    overflown = false;
    notifyAll();
  }

  /**
   * Waits as long as is left between two tries, whatever is said meanwhile; whether to try again.
   */
  private synchronized boolean pause() {
    long end = System.nanoTime() + TimeUnit.MILLISECONDS.toNanos(MILLIS_BETWEEN_TRIES);
    long left = MILLIS_BETWEEN_TRIES;
    while (!closed && left > 0) {
      if (!waited(left)) {
        return false;
      }
      left = TimeUnit.NANOSECONDS.toMillis(end - System.nanoTime());
    }
    return !closed;
  }

  @SuppressWarnings("WaitNotInLoop") // Who calls looks again, or tries again.
  private boolean waited(long millis) {
    try {
      wait(millis);
      return true;
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return false;
    }
  }

  private synchronized boolean drained() {
    long begin = System.nanoTime();
    while (!waiting.isEmpty() || underway > 0) {
      long most = failure.isEmpty() ? patience.toMillis() : MILLIS_FOR_A_STORE_THAT_FAILS;
      long left = most - (System.nanoTime() - begin) / 1_000_000;
      if (left <= 0 || !writer.isAlive() || !waited(left)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public List<Map<String, String>> select(String query, Duration within) {
    if (!drained()) {
      throw new KnowledgeException(notTaken());
    }
    return storage.select(query, within);
  }

  private synchronized String notTaken() {
    return failure.isEmpty()
        ? "The store has not taken within %d s what was to be kept; see to it, or ask again later."
            .formatted(patience.toSeconds())
        : failure + " See to it, and ask again.";
  }

  @Override
  public boolean isLasting() {
    return storage.isLasting();
  }

  @Override
  public void close() {
    if (!drained()) {
      LOG.error("What was said last is not in the store: it did not take it in time.");
    }
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    try {
      writer.join(patience.toMillis());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
    storage.close();
  }
}
