package org.maestro.launch;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;
import org.maestro.coordination.api.StoryEntry;

/**
 * Prints a story for people: simulated time, what kind of news it is, and the sentence. Any thread
 * may use it.
 */
final class StoryPrinter {
  private static final int INDENT = 21;
  private static final int TEXT_WIDTH = 79;

  private final PrintWriter out;
  private final Duration from;

  /**
   * @param from the simulated moment that counts as zero
   */
  StoryPrinter(PrintWriter out, Duration from) {
    this.out = out;
    this.from = from;
  }

  synchronized void print(StoryEntry entry) {
    out.print(
        String.format(
            Locale.ROOT,
            "%8.1f s  %-8s %s%n",
            entry.at().minus(from).toMillis() / 1000.0,
            word(entry.kind()),
            wrapped(entry.text())));
    out.flush();
  }

  /** Lines of a width that terminals have, indented below the first; none is of the text. */
  private static String wrapped(String text) {
    StringBuilder lines = new StringBuilder();
    int length = 0;
    for (String word : text.strip().split("\\s+")) {
      if (length > 0 && length + 1 + word.length() > TEXT_WIDTH) {
        lines.append(System.lineSeparator()).append(" ".repeat(INDENT));
        length = 0;
      } else if (length > 0) {
        lines.append(' ');
        length++;
      }
      lines.append(word);
      length += word.length();
    }
    return lines.toString();
  }

  private static String word(StoryEntry.Kind kind) {
    return kind.name().toLowerCase(Locale.ROOT);
  }
}
