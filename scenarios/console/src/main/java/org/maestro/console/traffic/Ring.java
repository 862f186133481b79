package org.maestro.console.traffic;

import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;

/**
 * The latest of what went by, numbered from 1, up to a number and a weight. Any thread may use it.
 */
public final class Ring<T> {
  /** One that is kept. */
  public record Kept<T>(long number, T what, long weight) {}

  private final int most;
  private final long heaviest;
  private final Deque<Kept<T>> kept = new ArrayDeque<>();
  private long latest;
  private long weight;

  /**
   * @param most that are kept
   * @param heaviest they are together; the latest one is kept in any case
   */
  public Ring(int most, long heaviest) {
    this.most = most;
    this.heaviest = heaviest;
  }

  /** Returns its number. */
  public synchronized long add(T what, long its) {
    kept.addLast(new Kept<>(++latest, what, its));
    weight += its;
    while (kept.size() > most || weight > heaviest && kept.size() > 1) {
      weight -= kept.removeFirst().weight();
    }
    return latest;
  }

  /** There is news, though nothing to keep. */
  synchronized void pass() {
    latest++;
  }

  /** The number of the latest news; 0 before there is any. */
  public synchronized long latest() {
    return latest;
  }

  /** The number of the oldest one that is kept, or of the next where there is none. */
  synchronized long oldest() {
    return kept.isEmpty() ? latest + 1 : kept.getFirst().number();
  }

  /** Those kept that came after one and not after the other, oldest first. */
  public synchronized List<Kept<T>> between(long after, long last) {
    return kept.stream().filter(one -> one.number() > after && one.number() <= last).toList();
  }

  synchronized Optional<Kept<T>> find(long number) {
    return kept.stream().filter(one -> one.number() == number).findFirst();
  }
}
