package org.maestro.platform.guard;

import java.util.BitSet;
import java.util.Map;
import org.maestro.rats.bounded.BoundedMap;

/**
 * The record of the numbered messages that have come from each sending process, so that none counts
 * twice. Of each process the latest numbers are told apart, older ones count as come; so no clocks
 * are compared, and memory is bounded. Thread-safe.
 */
final class ReplayWindow {
  /** So many messages may overtake one. */
  static final int WIDTH = 1 << 15;

  private static final int MOST_PROCESSES = 500;

  private final Map<String, Numbers> numbersByLife = BoundedMap.ofLatelyUsed(MOST_PROCESSES);

  /** Each number has a bit, as its remainder; those of numbers not yet come are clear. */
  private static final class Numbers {
    private final BitSet come = new BitSet(WIDTH);
    private long highest;
  }

  /**
   * @param life of the sending process
   * @param number of the message, counted from 1
   * @return whether it has not come before
   */
  synchronized boolean come(String life, long number) {
    Numbers numbers = numbersByLife.computeIfAbsent(life, l -> new Numbers());
    if (number <= numbers.highest - WIDTH || number < 1) {
      return false;
    }
    if (number > numbers.highest) {
      long first = Math.max(numbers.highest + 1, number - WIDTH + 1);
      for (long skipped = first; skipped <= number; skipped++) {
        numbers.come.clear((int) (skipped % WIDTH));
      }
      numbers.highest = number;
    }
    int bit = (int) (number % WIDTH);
    if (numbers.come.get(bit)) {
      return false;
    }
    numbers.come.set(bit);
    return true;
  }

  /** The message could not be delivered, and may come again. */
  synchronized void undo(String life, long number) {
    Numbers numbers = numbersByLife.get(life);
    if (numbers != null && number > numbers.highest - WIDTH && number <= numbers.highest) {
      numbers.come.clear((int) (number % WIDTH));
    }
  }
}
