package org.maestro.language.wording;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.maestro.language.grammar.Grammar;

/** How long something takes or took, as people say it. Immutable. */
public final class SpanWords {
  private static final double FEW_SECONDS = 10;
  private static final double MINUTES_UP_TO = 60;
  private static final double MINUTE_SECONDS = 60;
  private static final double HOUR_SECONDS = 3600;
  private static final double DAY_SECONDS = 86_400;

  private final Phrases phrases;

  public SpanWords(Grammar grammar) {
    this.phrases = new Phrases(grammar);
  }

  /** Such as two minutes. */
  public String of(Duration span) {
    double seconds = span.toMillis() / 1000.0;
    if (seconds < FEW_SECONDS) {
      return phrases.of("few-seconds");
    } else if (seconds < MINUTE_SECONDS) {
      return counted("one-second", "many-second", seconds);
    } else if (seconds < MINUTES_UP_TO * MINUTE_SECONDS) {
      return counted("one-minute", "many-minute", seconds / MINUTE_SECONDS);
    } else if (seconds < 2 * DAY_SECONDS) {
      return counted("one-hour", "many-hour", seconds / HOUR_SECONDS);
    }
    return counted("one-day", "many-day", seconds / DAY_SECONDS);
  }

  /** Such as one minute and 35 seconds. */
  public String exactly(Duration span) {
    List<String> parts = new ArrayList<>();
    if (span.toHours() > 0) {
      parts.add(counted("one-hour", "many-hour", (double) span.toHours()));
    }
    if (span.toMinutesPart() > 0) {
      parts.add(counted("one-minute", "many-minute", span.toMinutesPart()));
    }
    if (span.toSecondsPart() > 0 || parts.isEmpty()) {
      parts.add(counted("one-second", "many-second", span.toSecondsPart()));
    }
    return phrases.listed(parts);
  }

  private String counted(String one, String many, double number) {
    long whole = Math.round(number);
    return whole == 1
        ? phrases.of(one)
        : phrases.of(many, Map.of("number", phrases.number((double) whole)));
  }

  /** Such as two minutes ago. */
  public String ago(Duration age) {
    return age.toMillis() / 1000.0 < FEW_SECONDS
        ? phrases.of("just-now")
        : phrases.of("ago", Map.of("span", of(age)));
  }
}
