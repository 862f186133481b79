package org.maestro.console;

import java.util.concurrent.Future;
import java.util.concurrent.RejectedExecutionException;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import org.maestro.console.traffic.Source;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The news of a source, told to all who listen: first all that is kept, then what is new, gathered
 * for a tenth of a second. As long as nobody listens nothing is looked at.
 */
final class Broadcast implements EventSource {
  private static final Logger LOG = LoggerFactory.getLogger(Broadcast.class);
  private static final long GATHERED_MILLIS = 100;

  private final String event;
  private final Source source;
  private final ScheduledExecutorService thread;

  // Both are the thread's own.
  private final Listeners listeners = new Listeners();
  private long told;

  /**
   * @param event the name under which it is told
   * @param thread a single one, which does the work; ended by who gave it
   */
  Broadcast(String event, Source source, ScheduledExecutorService thread) {
    this.event = event;
    this.source = source;
    this.thread = thread;
  }

  /** Returns what goes on until it is cancelled, or the thread is ended. */
  Future<?> begin() {
    return thread.scheduleWithFixedDelay(
        this::guarded, GATHERED_MILLIS, GATHERED_MILLIS, TimeUnit.MILLISECONDS);
  }

  @Override
  public void listen(EventQueue listener, Runnable then) {
    later(
        () -> {
          try {
            admit(listener);
          } finally {
            then.run();
          }
        });
  }

  /** The others have heard by then what the new one is told. */
  private void admit(EventQueue listener) {
    if (listeners.isEmpty()) {
      told = source.latest();
    } else {
      tell();
    }
    if (listeners.admit(listener)) {
      listener.add(event, source.between(0, told));
    }
  }

  @Override
  public void leave(EventQueue listener) {
    later(() -> listeners.leave(listener));
  }

  private void later(Runnable work) {
    try {
      thread.execute(work);
    } catch (RejectedExecutionException e) {
      LOG.debug("Somebody came or went after the console had ended");
    }
  }

  private void tell() {
    long latest = source.latest();
    if (!listeners.isEmpty() && latest > told) {
      listeners.tell(event, source.between(told, latest));
      told = latest;
    }
  }

  /** Who has thrown once is asked again all the same. */
  private void guarded() {
    try {
      tell();
    } catch (RuntimeException e) {
      LOG.error("News could not be told to the console's listeners", e);
    }
  }
}
