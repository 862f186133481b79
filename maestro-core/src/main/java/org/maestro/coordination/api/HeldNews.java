package org.maestro.coordination.api;

import java.util.List;

/**
 * News of a held goal, told to its requester while the goal lives.
 *
 * @param confirmed it is so, and that does not rest on the word of those alone who did it
 * @param reasons why it is not so and cannot be made so, in sentences; empty unless that is known
 */
public record HeldNews(String goalId, Kind kind, boolean confirmed, List<String> reasons) {

  public HeldNews {
    reasons = List.copyOf(reasons);
  }

  /** The change of which the news tells. */
  public enum Kind {
    /** It is so for the first time. */
    HELD,
    /** It is no longer so, or it was found that nobody can make it so; it goes on being tried. */
    LOST,
    /** It is so again. */
    HELD_AGAIN;

    public boolean isSo() {
      return this != LOST;
    }
  }
}
