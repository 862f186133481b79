package org.maestro.agents.runtime;

import java.util.Iterator;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.PriorityQueue;

/**
 * The order in which work is done that several ask for. Those who ask come in turn, whoever asks
 * for how much; what can wait is overtaken by what cannot, and by nothing once its time has come.
 * Any thread.
 */
final class PlanningTurns {
  /**
   * @param dueNanos from then on it waits for no other; by the clock of {@link System#nanoTime}
   */
  private record Turn(long dueNanos, long sequence, Runnable work) implements Comparable<Turn> {
    @Override
    public int compareTo(Turn other) {
      int byTime = Long.signum(dueNanos - other.dueNanos);
      return byTime != 0 ? byTime : Long.compare(sequence, other.sequence);
    }

    boolean isDue(long nowNanos) {
      return dueNanos - nowNanos <= 0;
    }
  }

  /** Who was served longest ago comes first. */
  private final Map<String, PriorityQueue<Turn>> waiting = new LinkedHashMap<>();

  private long sequence;

  synchronized void add(Runnable work, String requester, long dueNanos) {
    waiting
        .computeIfAbsent(requester, absent -> new PriorityQueue<>())
        .add(new Turn(dueNanos, sequence++, work));
  }

  /** Takes the next; there has to be one. */
  synchronized Runnable next(long nowNanos) {
    String requester =
        waiting.entrySet().stream()
            .filter(entry -> entry.getValue().element().isDue(nowNanos))
            .map(Map.Entry::getKey)
            .findFirst()
            .orElseGet(this::whoWaitsForTheEarliest);
    PriorityQueue<Turn> its = waiting.remove(requester);
    Turn turn = its.remove();
    if (!its.isEmpty()) {
      waiting.put(requester, its);
    }
    return turn.work();
  }

  private String whoWaitsForTheEarliest() {
    Iterator<Map.Entry<String, PriorityQueue<Turn>>> entries = waiting.entrySet().iterator();
    Map.Entry<String, PriorityQueue<Turn>> earliest = entries.next();
    while (entries.hasNext()) {
      Map.Entry<String, PriorityQueue<Turn>> other = entries.next();
      if (other.getValue().element().compareTo(earliest.getValue().element()) < 0) {
        earliest = other;
      }
    }
    return earliest.getKey();
  }
}
