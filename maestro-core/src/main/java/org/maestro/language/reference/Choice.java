package org.maestro.language.reference;

import java.util.List;

/** Which of several that fit a description is meant. */
sealed interface Choice {
  /** Nothing is said of that. */
  Choice UNSAID = new Unsaid();

  record Unsaid() implements Choice {}

  /**
   * The one at a place in their order.
   *
   * @param number from 1 on, the last by -1
   */
  record Nth(int number) implements Choice {}

  /**
   * The one of which a number is the greatest, or the smallest.
   *
   * @param fluents of which the first is meant that all of them have
   */
  record Extreme(List<String> fluents, boolean greatest) implements Choice {
    public Extreme {
      fluents = List.copyOf(fluents);
    }
  }
}
