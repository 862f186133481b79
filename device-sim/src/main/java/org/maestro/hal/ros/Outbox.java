package org.maestro.hal.ros;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/**
 * What waits to be sent: of each kind only the last, such as of velocities for one base. Any thread
 * may call.
 */
final class Outbox {

  private final Map<String, String> waiting = new LinkedHashMap<>();

  synchronized void put(String kind, String message) {
    waiting.remove(kind);
    waiting.put(kind, message);
    notifyAll();
  }

  synchronized void clear() {
    waiting.clear();
  }

  /** The one that has waited longest; empty when none comes for so long. */
  synchronized Optional<String> take(Duration longest) throws InterruptedException {
    long end = System.nanoTime() + longest.toNanos();
    while (waiting.isEmpty()) {
      long left = end - System.nanoTime();
      if (left <= 0) {
        return Optional.empty();
      }
      TimeUnit.NANOSECONDS.timedWait(this, left);
    }
    String kind = waiting.keySet().iterator().next();
    return Optional.ofNullable(waiting.remove(kind));
  }
}
