package org.maestro.experiment;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.experiment.setting.SettingException;

/**
 * A goal of an evening.
 *
 * @param at when it is stated, counted from the evening's begin; empty: as soon as all that were
 *     stated before have ended
 * @param goal in MAESTRO-SL
 */
public record Wish(Optional<Duration> at, String goal) {
  private static final Pattern LINE = Pattern.compile("(?:(\\d{1,6}(?:\\.\\d+)?)\\s+)?(\\(.*\\))");
  private static final double MILLIS = 1e3;

  /** That is stated when all before it have ended. */
  public static Wish of(String goal) {
    return new Wish(Optional.empty(), goal);
  }

  /**
   * Reads goals, one a line, each with the second before it at which it is stated or with none.
   * Empty lines and what stands behind {@code #} are left out.
   *
   * @param name how the text is called in messages
   * @throws SettingException for the first line that is none of this
   */
  public static List<Wish> read(String name, String text) {
    List<Wish> wishes = new ArrayList<>();
    List<String> lines = text.lines().toList();
    for (int i = 0; i < lines.size(); i++) {
      String line = lines.get(i).replaceFirst("(^|\\s)#.*", "").strip();
      if (!line.isEmpty()) {
        wishes.add(read(name, i + 1, line));
      }
    }
    return List.copyOf(wishes);
  }

  private static Wish read(String name, int number, String line) {
    Matcher matcher = LINE.matcher(line);
    if (!matcher.matches()) {
      throw new SettingException(
          "%s:%d: %s is no goal; write one a line, such as (nextTo Cup Bob), or 90 (nextTo Cup Bob) for one that comes after 90 s."
              .formatted(name, number, line));
    }
    return new Wish(
        Optional.ofNullable(matcher.group(1))
            .map(seconds -> Duration.ofMillis(Math.round(MILLIS * Double.parseDouble(seconds)))),
        matcher.group(2));
  }
}
