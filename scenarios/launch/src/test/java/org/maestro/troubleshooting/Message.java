package org.maestro.troubleshooting;

import java.util.Comparator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

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

  /** So many characters together are not in a sentence by chance. */
  private static final int TELLING = 8;

  /** What stands for what is filled in. */
  static final String ANYTHING = "…";

  /** Whether somebody who got the sentence finds this in it, whatever was filled in. */
  boolean isIn(String sentence) {
    String[] parts = text.replaceAll("\\.$", "").split(ANYTHING);
    return Stream.of(parts).anyMatch(part -> part.strip().length() >= TELLING)
        && Stream.of(parts)
            .map(part -> Pattern.quote(part.strip()))
            .collect(Collectors.collectingAndThen(Collectors.joining(".*"), Pattern::compile))
            .matcher(sentence)
            .find();
  }

  @Override
  public int compareTo(Message other) {
    return ORDER.compare(this, other);
  }
}
