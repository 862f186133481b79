package org.maestro.language.wording;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.BiFunction;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.maestro.language.grammar.ReportRule;

/**
 * A rule for reports, with its text taken apart: words as they are, and what changes. Immutable.
 */
final class ReportPattern {
  private static final Pattern PLACE = Pattern.compile("\\{(\\w+):(\\w+)}");

  private final ReportRule rule;

  /** One more than there are places. */
  private final List<String> words = new ArrayList<>();

  private final List<Place> places = new ArrayList<>();

  private record Place(String name, String category) {}

  /** What stands in the places. */
  record Found(ReportRule rule, Map<String, Reported> values) {
    int foreign() {
      return values.values().stream().mapToInt(Reported::foreign).sum();
    }
  }

  ReportPattern(ReportRule rule) {
    this.rule = rule;
    String text = withoutFullStop(rule.text());
    Matcher place = PLACE.matcher(text);
    int at = 0;
    while (place.find()) {
      words.add(text.substring(at, place.start()));
      places.add(new Place(place.group(1), place.group(2)));
      at = place.end();
    }
    words.add(text.substring(at));
  }

  String category() {
    return rule.category();
  }

  /** Three dots are no full stop. */
  static String withoutFullStop(String text) {
    String stripped = text.strip();
    return stripped.endsWith(".") && !stripped.endsWith("..")
        ? stripped.substring(0, stripped.length() - 1)
        : stripped;
  }

  /**
   * What stands in the places of a text; empty when it says something else. Of several ways that is
   * taken in which least stays as it was written.
   *
   * @param part reads a part of the text as what the category names
   */
  Optional<Found> in(String text, BiFunction<String, String, Optional<Reported>> part) {
    String first = words.get(0);
    if (!text.regionMatches(true, 0, first, 0, Math.min(1, first.length()))
        || !text.startsWith(
            first.substring(Math.min(1, first.length())), Math.min(1, first.length()))
        || text.length() < first.length()) {
      return Optional.empty();
    }
    return places.isEmpty()
        ? Optional.of(new Found(rule, Map.of())).filter(found -> text.length() == first.length())
        : from(0, first.length(), text, part);
  }

  /** From the place of that number on, which begins there. */
  private Optional<Found> from(
      int number, int begin, String text, BiFunction<String, String, Optional<Reported>> part) {
    if (number == places.size()) {
      return begin == text.length() ? Optional.of(new Found(rule, Map.of())) : Optional.empty();
    }
    String next = words.get(number + 1);
    boolean isLast = number == places.size() - 1;
    if (isLast && !text.endsWith(next)) {
      return Optional.empty();
    }
    Optional<Found> best = Optional.empty();
    int end = isLast ? text.length() - next.length() : text.indexOf(next, begin + 1);
    while (end > begin) {
      Optional<Found> found = with(number, begin, end, text, part);
      if (found.isPresent() && (best.isEmpty() || found.get().foreign() < best.get().foreign())) {
        best = found;
      }
      if (isLast || best.isPresent() && best.get().foreign() == 0) {
        break;
      }
      end = text.indexOf(next, end + 1);
    }
    return best;
  }

  private Optional<Found> with(
      int number,
      int begin,
      int end,
      String text,
      BiFunction<String, String, Optional<Reported>> part) {
    Place place = places.get(number);
    Optional<Reported> value = part.apply(place.category(), text.substring(begin, end));
    if (value.isEmpty()) {
      return Optional.empty();
    }
    return from(number + 1, end + words.get(number + 1).length(), text, part)
        .map(
            found -> {
              Map<String, Reported> values = new HashMap<>(found.values());
              values.put(place.name(), value.get());
              return new Found(rule, values);
            });
  }
}
