package org.maestro.console.history;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;

/**
 * What was recorded up to a moment, from when all was told.
 *
 * @param lines an entry each, oldest first
 * @param heard when the last of them was recorded
 * @param clock the platform's, then
 * @param next the platform's clock when something was recorded after that
 */
record Past(List<String> lines, Instant heard, double clock, double next) {

  /** What was so at a moment, which is not before the last entry. */
  ObjectNode document(Instant at) {
    PastState state = new PastState();
    double speed = 0;
    for (String line : lines) {
      Optional<Entry> entry = Entry.read(line);
      if (entry.isPresent()) {
        speed = entry.get().told().path(Archive.SPEED).asDouble(speed);
        state.take(entry.get());
      }
    }
    Duration since = Duration.between(heard, at);
    double then = Math.min(next, clock + since.toMillis() / 1000.0 * speed);
    ObjectNode document = state.document(then);
    return document
        .put("at", at.toString())
        .put("clock_s", then)
        .put("recorded", since.compareTo(Archive.LONGEST_SILENCE) < 0);
  }
}
