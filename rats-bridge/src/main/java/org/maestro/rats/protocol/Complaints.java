package org.maestro.rats.protocol;

import java.util.Map;
import java.util.function.LongSupplier;
import org.maestro.rats.bounded.BoundedMap;

/**
 * Keeps whoever sends rubbish from filling the log: one line for each sender and minute of wall
 * time. Safe for use by several threads.
 */
public final class Complaints {

  private static final long MINUTE_NANOS = 60_000_000_000L;
  private static final int MOST_SENDERS = 1_024;
  private static final int MOST_CHARACTERS = 400;

  private final LongSupplier nanos;
  private final Map<String, Long> lastBySender = BoundedMap.ofLatelyUsed(MOST_SENDERS);

  public Complaints() {
    this(System::nanoTime);
  }

  /**
   * @param nanos any time that goes on, in nanoseconds
   */
  Complaints(LongSupplier nanos) {
    this.nanos = nanos;
  }

  /** Of a text that may quote what a sender wrote, however long that is. */
  public static String shortened(String text) {
    return WholeText.shortened(String.valueOf(text), MOST_CHARACTERS);
  }

  /**
   * Whether a complaint about the sender may be logged now; the next one may in a minute.
   *
   * @param sender as the topic names it, or the topic
   */
  public synchronized boolean isDue(String sender) {
    long now = nanos.getAsLong();
    Long last = lastBySender.get(sender);
    if (last != null && now - last < MINUTE_NANOS) {
      return false;
    }
    lastBySender.put(sender, now);
    return true;
  }
}
