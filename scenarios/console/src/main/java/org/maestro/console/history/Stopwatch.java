package org.maestro.console.history;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.NullNode;
import java.time.Duration;

/** How long something took, each time since somebody looked. Any thread may use it. */
final class Stopwatch {
  private long times;
  private double lowest;
  private double sum;
  private double highest;

  synchronized void took(Duration time) {
    double millis = time.toNanos() / 1e6;
    lowest = times == 0 ? millis : Math.min(lowest, millis);
    highest = times == 0 ? millis : Math.max(highest, millis);
    sum += millis;
    times++;
  }

  /** The lowest, the mean and the highest in milliseconds; null when there is none. Begins anew. */
  synchronized JsonNode look() {
    if (times == 0) {
      return NullNode.getInstance();
    }
    JsonNode figures =
        JsonNodeFactory.instance.arrayNode().add(lowest).add(sum / times).add(highest);
    times = 0;
    sum = 0;
    return figures;
  }
}
