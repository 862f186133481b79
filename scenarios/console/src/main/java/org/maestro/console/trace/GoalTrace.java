package org.maestro.console.trace;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;

/** The latest of what was said for one goal, in the order in which it was begun to be said. */
final class GoalTrace {
  private final int most;
  private final Map<Object, TraceEntry> entries = new LinkedHashMap<>();
  private long number;
  private long dropped;

  /** Who says something of one call again and again is told once. */
  private record Stream(
      TraceEntry.Layer layer,
      String kind,
      Optional<String> from,
      Optional<String> to,
      Optional<String> call) {}

  /**
   * @param most entries that are kept
   */
  GoalTrace(int most) {
    this.most = most;
  }

  void add(TraceEntry entry) {
    put(++number, entry);
  }

  /** What is said again and again, each time with other values. */
  void addRepeated(TraceEntry entry) {
    put(new Stream(entry.layer(), entry.kind(), entry.from(), entry.to(), entry.call()), entry);
  }

  private void put(Object key, TraceEntry entry) {
    entries.merge(key, entry, TraceEntry::again);
    if (entries.size() > most) {
      Iterator<TraceEntry> eldest = entries.values().iterator();
      dropped += eldest.next().times();
      eldest.remove();
    }
  }

  List<TraceEntry> entries() {
    return List.copyOf(entries.values());
  }

  /** How much was said that is not kept any more. */
  long dropped() {
    return dropped;
  }
}
