package org.maestro.troubleshooting;

import java.util.Comparator;

/**
 * A sentence that people get when something is wrong, or a part of one.
 *
 * @param where the class that says it, with its package, without {@code org.maestro}
 * @param kind the error type, or in what else it is said
 * @param text as it stands in the source; what is filled in is an ellipsis
 */
record Message(String where, String kind, String text) implements Comparable<Message> {
  private static final Comparator<Message> ORDER =
      Comparator.comparing(Message::text)
          .thenComparing(Message::kind)
          .thenComparing(Message::where);

  /** What stands for what is filled in. */
  static final String ANYTHING = "…";

  @Override
  public int compareTo(Message other) {
    return ORDER.compare(this, other);
  }
}
