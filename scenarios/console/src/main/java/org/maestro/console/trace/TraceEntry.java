package org.maestro.console.trace;

import java.time.Duration;
import java.time.Instant;
import java.util.Locale;
import java.util.Optional;

/**
 * Something that was said for a goal, once or again and again.
 *
 * @param kind of the story's sentence or the message, or the performative
 * @param from who said it; empty: the story
 * @param to whom; empty: all
 * @param call on the bus that it belongs to
 * @param text what was said, the latest time, perhaps shortened
 * @param at simulated time since the platform's clock began
 * @param wall the same
 * @param times how often
 * @param until when it was said last
 */
record TraceEntry(
    Layer layer,
    String kind,
    Optional<String> from,
    Optional<String> to,
    Optional<String> call,
    String text,
    Duration at,
    Instant wall,
    int times,
    Duration until) {

  /** Where something is said (Three-layered architecture, 3). */
  enum Layer {
    STORY,
    AGENTS,
    BUS;

    String word() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  static TraceEntry of(
      Layer layer,
      String kind,
      Optional<String> from,
      Optional<String> to,
      Optional<String> call,
      String text,
      Duration at,
      Instant wall) {
    return new TraceEntry(layer, kind, from, to, call, text, at, wall, 1, at);
  }

  /** This, said again in other words. */
  TraceEntry again(TraceEntry latest) {
    return new TraceEntry(
        layer, kind, from, to, call, latest.text, at, wall, times + 1, latest.until);
  }
}
