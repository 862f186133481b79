package org.maestro.language.wording;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.LocalTime;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.language.grammar.Grammar;
import org.maestro.sl.Occasion;

/** When something begins or ends, as people say it. Immutable. */
final class OccasionWords {
  private final Phrases phrases;
  private final SpanWords spans;
  private final FactWords facts;

  OccasionWords(Grammar grammar, FactWords facts) {
    this.phrases = new Phrases(grammar);
    this.spans = new SpanWords(grammar);
    this.facts = facts;
  }

  /**
   * Such as at 22:00 every day.
   *
   * @param end whether it ends then; else it begins
   */
  Optional<String> of(Occasion occasion, boolean end) {
    if (occasion instanceof Occasion.Event event) {
      return facts
          .of(event.condition())
          .map(
              fact ->
                  phrases.of(
                      end ? "until-so" : event.again() ? "whenever-so" : "once-so",
                      Map.of("fact", fact)));
    } else if (occasion instanceof Occasion.After after) {
      Duration span = Duration.ofMillis((long) (after.seconds() * 1000));
      return Optional.of(
          phrases.of(end ? "until-span" : "after-span", Map.of("span", spans.of(span))));
    }
    Occasion.At at = (Occasion.At) occasion;
    String time = phrases.of(end ? "until-time" : "at-time", Map.of("time", clock(at.time())));
    return Optional.of(
        at.days().isEmpty()
            ? time
            : phrases.of(
                at.again() ? "every-time" : "on-time",
                Map.of("when", time, "days", days(at.days()))));
  }

  private static String clock(LocalTime time) {
    return String.format(Locale.ROOT, "%02d:%02d", time.getHour(), time.getMinute());
  }

  private String days(Set<DayOfWeek> days) {
    if (days.size() == DayOfWeek.values().length) {
      return phrases.of("day");
    }
    List<String> names =
        days.stream().sorted().map(day -> phrases.of(day.name().toLowerCase(Locale.ROOT))).toList();
    return phrases.listed(names);
  }
}
