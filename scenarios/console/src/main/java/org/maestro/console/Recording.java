package org.maestro.console;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import org.maestro.console.history.History;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The listener that never goes: it hears what pages hear and has it recorded, on a thread of its
 * own, so that a slow disk keeps nobody from hearing. When it was too slow itself it begins anew
 * with all that is so, as pages do.
 */
final class Recording implements AutoCloseable {
  private static final Logger LOG = LoggerFactory.getLogger(Recording.class);
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final long END_MILLIS = 5_000;
  private static final long AGAIN_MILLIS = 1_000;

  private final EventSource events;
  private final History history;
  private final Duration measured;
  private final Thread thread = new Thread(this::record, "console-history");

  /**
   * @param measured how often figures are recorded
   */
  Recording(EventSource events, History history, Duration measured) {
    this.events = events;
    this.history = history;
    this.measured = measured;
    thread.setDaemon(true);
  }

  void begin() {
    thread.start();
  }

  private void record() {
    try {
      history.begin();
      while (true) {
        listen();
        TimeUnit.MILLISECONDS.sleep(AGAIN_MILLIS);
      }
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    } finally {
      history.close();
    }
  }

  /** Until it was too slow, or there was no room for it. */
  private void listen() throws InterruptedException {
    EventQueue queue = new EventQueue();
    events.listen(queue, () -> {});
    try {
      long due = System.nanoTime() + measured.toNanos();
      while (!queue.isOver()) {
        Optional<EventQueue.Event> event = queue.next(Duration.ofNanos(due - System.nanoTime()));
        event.ifPresent(told -> guarded(() -> take(told)));
        if (System.nanoTime() - due >= 0) {
          guarded(history::measure);
          due += measured.toNanos();
        }
      }
    } finally {
      events.leave(queue);
    }
  }

  /** What cannot be recorded is missing, and what comes after it is recorded all the same. */
  private static void guarded(Runnable work) {
    try {
      work.run();
    } catch (RuntimeException e) {
      LOG.error("What happened could not be recorded", e);
    }
  }

  private void take(EventQueue.Event event) {
    try {
      history.take(event.name(), MAPPER.readTree(event.document()));
    } catch (JsonProcessingException e) {
      throw new IllegalStateException(e);
    }
  }

  @Override
  public void close() {
    thread.interrupt();
    try {
      thread.join(END_MILLIS);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
    }
  }
}
