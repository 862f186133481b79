package org.maestro.console;

import com.fasterxml.jackson.databind.JsonNode;
import java.time.Duration;
import java.util.Optional;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import java.util.concurrent.TimeUnit;

/**
 * The events on their way to one listener. Who does not take them in time is let go, and comes back
 * for all that is so then. Any thread may use it.
 */
final class EventQueue {
  /** Some minutes of a busy home. */
  private static final int MOST_WAITING = 2_000;

  /** What is told, under its name. */
  record Event(String name, String document) {}

  private final BlockingQueue<Event> waiting = new LinkedBlockingQueue<>(MOST_WAITING);
  private volatile boolean over;

  /** Returns whether the listener is still there. */
  boolean add(String name, JsonNode document) {
    if (!waiting.offer(new Event(name, document.toString()))) {
      over = true;
    }
    return !over;
  }

  /** The same of what is worth nothing late: it takes the place of one of that name that waits. */
  boolean addInPlace(String name, JsonNode document) {
    waiting.removeIf(event -> event.name().equals(name));
    return add(name, document);
  }

  /** The next one; empty when nothing has happened for so long. */
  Optional<Event> next(Duration patience) throws InterruptedException {
    return Optional.ofNullable(waiting.poll(patience.toNanos(), TimeUnit.NANOSECONDS));
  }

  void end() {
    over = true;
  }

  boolean isOver() {
    return over;
  }
}
