package org.maestro.launch;

import java.io.PrintWriter;
import java.time.Duration;
import java.util.Locale;
import org.maestro.coordination.StoryEntry;

/**
 * Prints a story for people: simulated time, what kind of news it is, and the sentence. Any thread
 * may use it.
 */
final class StoryPrinter {
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
    out.printf(
        Locale.ROOT,
        "%8.1f s  %-8s %s%n",
        entry.at().minus(from).toMillis() / 1000.0,
        word(entry.kind()),
        entry.text().replace("\n", "\n" + " ".repeat(21)));
    out.flush();
  }

  private static String word(StoryEntry.Kind kind) {
    return kind.name().toLowerCase(Locale.ROOT);
  }
}
