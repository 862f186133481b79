package org.maestro.storage;

import java.io.IOException;
import java.util.ArrayDeque;
import java.util.Deque;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Writes what may be missing, such as stories, on a thread of its own and in the order in which it
 * comes: a slow disk holds nobody up. What the disk refuses, and what comes while too many bytes
 * wait, is left away; that is told once, and that it is over. So is, without a word, what comes
 * after its end. Any thread may use it.
 */
public final class WritingAside implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(WritingAside.class);
  private static final long MOST_BYTES_WAITING = 1 << 20;
  private static final long END_LIMIT_MILLIS = 5_000;

  private final String what;
  private final Thread thread;
  private final boolean atOnce;

  /** Guarded by this. */
  private final Deque<Waiting> waiting = new ArrayDeque<>();

  /** Guarded by this. */
  private long bytesWaiting;

  /** Guarded by this. */
  private boolean closed;

  /** Guarded by this. */
  private long missing;

  /** Something that is written, or fails. */
  public interface Writing {
    void write() throws IOException;
  }

  private record Waiting(long bytes, Writing writing, Runnable after) {}

  private WritingAside(String what, boolean atOnce) {
    this.what = what;
    this.atOnce = atOnce;
    this.thread = new Thread(this::write, "maestro-aside");
    thread.setDaemon(true);
  }

  /**
   * Writes beside.
   *
   * @param what is written, in the plural, as the beginning of a sentence
   */
  public static WritingAside begin(String what) {
    WritingAside aside = new WritingAside(what, false);
    aside.thread.start();
    return aside;
  }

  /** Writes on the caller's thread, for clocks on which all happens in order. */
  public static WritingAside atOnce(String what) {
    return new WritingAside(what, true);
  }

  /**
   * Has it written.
   *
   * @param bytes that it takes, about
   */
  public void add(long bytes, Writing writing) {
    add(bytes, writing, () -> {});
  }

  /**
   * The same.
   *
   * @param after run when it is written or left away, but not after the end; it must not block
   */
  public void add(long bytes, Writing writing, Runnable after) {
    if (atOnce) {
      written(writing);
      after.run();
      return;
    }
    synchronized (this) {
      if (closed) {
        return;
      }
      if (bytesWaiting + bytes <= MOST_BYTES_WAITING) {
        waiting.addLast(new Waiting(bytes, writing, after));
        bytesWaiting += bytes;
        notifyAll();
        return;
      }
    }
    isMissing("the disk is slower than they come");
    after.run();
  }

  private void write() {
    try {
      while (true) {
        Waiting next;
        synchronized (this) {
          while (waiting.isEmpty()) {
            if (closed) {
              return;
            }
            wait();
          }
          next = waiting.removeFirst();
        }
        written(next.writing());
        next.after().run();
        synchronized (this) {
          bytesWaiting -= next.bytes();
        }
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }

  private void written(Writing writing) {
    try {
      writing.write();
      isThereAgain();
    } catch (IOException e) {
      isMissing(StorageFault.words(e));
    }
  }

  private synchronized void isMissing(String because) {
    if (missing++ == 0) {
      LOG.warn("{} cannot be kept now and will have gaps: {}.", what, because);
    }
  }

  private synchronized void isThereAgain() {
    if (missing > 0) {
      LOG.warn("{} can be kept again; lines that are missing: {}.", what, missing);
      missing = 0;
    }
  }

  /** Writes what waits, for some seconds at most. */
  @Override
  public void close() {
    synchronized (this) {
      closed = true;
      notifyAll();
    }
    try {
      if (thread.isAlive()) {
        thread.join(END_LIMIT_MILLIS);
        thread.interrupt();
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
