package org.maestro.assembly;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.knowledge.habits.HabitFile;
import org.maestro.knowledge.habits.HabitLog;

/**
 * The days before a platform begins, as far as habits were counted in them: a table with a line for
 * each kind of event, in which stand how many days ago it was ({@code 3} or {@code 1..14}), how
 * many minutes later or earlier than now, and what was counted. Immutable.
 */
public final class PastDays {
  private static final Pattern LINE =
      Pattern.compile("(\\d{1,3})(?:\\.\\.(\\d{1,3}))?\t(-?\\d{1,4})\t(\\(.+\\))");

  private final List<Event> events;

  private record Event(int daysAgo, int minutes, String counted) {
    Instant at(Instant now) {
      return now.minus(Duration.ofDays(daysAgo)).plus(Duration.ofMinutes(minutes));
    }
  }

  private PastDays(List<Event> events) {
    this.events = events;
  }

  /** Those that are shipped with a home. */
  public static PastDays shipped(String home) {
    String resource = "/histories/" + home + ".tsv";
    try (InputStream stream = PastDays.class.getResourceAsStream(resource)) {
      if (stream == null) {
        throw new IllegalArgumentException("There are no past days of " + home + ".");
      }
      return read(new String(stream.readAllBytes(), StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new UncheckedIOException("The past days of " + home + " cannot be read.", e);
    }
  }

  /**
   * Those of a table; lines that begin with {@code #} say nothing.
   *
   * @throws IllegalArgumentException when a line is no such line
   */
  public static PastDays read(String table) {
    List<Event> events = new ArrayList<>();
    table
        .lines()
        .filter(line -> !line.isBlank() && !line.startsWith("#"))
        .forEach(line -> add(line, events));
    return new PastDays(List.copyOf(events));
  }

  private static void add(String line, List<Event> events) {
    Matcher parts = LINE.matcher(line);
    if (!parts.matches()) {
      throw new IllegalArgumentException(
          "No past days: \"%s\"; write how many days ago, how many minutes later, and what, with tabulators between them."
              .formatted(line));
    }
    int first = Integer.parseInt(parts.group(1));
    int last = parts.group(2) == null ? first : Integer.parseInt(parts.group(2));
    for (int day = first; day <= last; day++) {
      events.add(new Event(day, Integer.parseInt(parts.group(3)), parts.group(4)));
    }
  }

  /**
   * Writes them where a platform with this data directory reads its habits.
   *
   * @param now when the platform begins
   */
  public void keepIn(Path dataDirectory, Instant now) {
    HabitLog log = new HabitFile(dataDirectory);
    events.forEach(event -> log.add(event.at(now) + " " + event.counted()));
  }
}
