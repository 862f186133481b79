package org.maestro.rats.link;

import java.util.concurrent.atomic.AtomicLong;
import org.maestro.rats.time.Clock;

/**
 * Ids of one caller's calls: its name, its life, and a number. No two of them are the same, also
 * after it was started again. Any thread may ask.
 */
final class CallIds {
  private final String life;
  private final String prefix;
  private final AtomicLong count = new AtomicLong();

  /**
   * @param sort told apart from other calls of the same caller; may be empty
   */
  CallIds(String caller, String sort, Clock clock) {
    this.life = Long.toString(clock.instant().toEpochMilli(), 36);
    this.prefix = caller + "-" + life + "-" + sort;
  }

  /** The caller's life, which began just now. */
  String life() {
    return life;
  }

  String next() {
    return prefix + count.incrementAndGet();
  }
}
