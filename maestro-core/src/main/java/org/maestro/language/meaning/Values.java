package org.maestro.language.meaning;

import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.maestro.language.grammar.Form;
import org.maestro.sl.Term;

/** Values that are said: numbers, time spans, times of day, words as they are. */
final class Values {
  private static final int NOON = 720;
  private static final int DAY = 1440;
  private static final int EVENING = 1080;
  private static final int DAWN = 360;
  private static final int HOUR = 60;
  private static final int HALF = 30;
  private static final int QUARTER = 15;

  static final String FAHRENHEIT = "DEG_F";

  /** What is asked for as a number may be said in these; minutes are a span. */
  private static final Set<String> UNITS_OF_NUMBERS = Set.of("DEG_C", FAHRENHEIT, "K", "M");

  private Values() {}

  /** The value of an amount, a span or a text; empty for everything else. */
  static Optional<Term> of(Form said) {
    // Words as they are may be any, and so may be called as a form is.
    return said.parts().isEmpty() ? word(said) : value(said);
  }

  private static Optional<Term> word(Form said) {
    return isReference(said.head()) ? Optional.empty() : Optional.of(new Term.Text(said.head()));
  }

  private static Optional<Term> value(Form said) {
    return switch (said.head()) {
      case "number", "percent", "points", "share" ->
          Optional.of(new Term.Number(Double.parseDouble(said.text(0))));
      case "quantity" ->
          UNITS_OF_NUMBERS.contains(said.text(1))
              ? Optional.of(new Term.Number(inCelsius(said)))
              : Optional.empty();
      case "span", "plus" -> Optional.of(new Term.Number(seconds(said)));
      case "text" -> Optional.of(new Term.Text(text(said).replaceFirst("^(, )+", "")));
      default -> Optional.empty();
    };
  }

  /** A quantity as it is, but a temperature in degrees Celsius or kelvin. */
  static double inCelsius(Form quantity) {
    double number = Double.parseDouble(quantity.text(0));
    return quantity.text(1).equals(FAHRENHEIT)
        ? Math.round((number - 32) / 1.8 * 10) / 10.0
        : number;
  }

  private static boolean isReference(String head) {
    return switch (head) {
      case "it",
          "them",
          "him",
          "speaker",
          "self",
          "everything",
          "somebody",
          "everybody",
          "_",
          "here",
          "there",
          "everywhere" ->
          true;
      default -> false;
    };
  }

  private static String text(Form said) {
    return said.is("text") ? text(said.part(0)) + " " + text(said.part(1)) : said.head();
  }

  /** A time span; seconds. */
  static double seconds(Form span) {
    if (span.is("plus")) {
      return seconds(span.part(0)) + seconds(span.part(1));
    }
    return Double.parseDouble(span.text(0)) * Double.parseDouble(span.text(1));
  }

  /**
   * A time of day.
   *
   * @param now what the clock shows; of two times that are called the same the next is meant
   * @return minutes after midnight; empty when there is no such time
   */
  static OptionalInt minuteOfDay(Form clock, OptionalInt now) {
    switch (clock.head()) {
      case "part":
        return inPart(clock, now);
      case "time":
        return inDay(time(clock.text(0)));
      case "timepm":
        return afternoon(time(clock.text(0)));
      case "am":
        return hours(clock) >= NOON + HOUR ? OptionalInt.empty() : inDay(hours(clock) % NOON);
      case "pm":
        return afternoon(hours(clock));
      case "half":
        return next(hours(clock) + HALF, now);
      case "tohalf":
        return next(hours(clock) - HALF, now);
      case "pastquarter":
        return next(hours(clock) + QUARTER, now);
      case "before":
        // So many minutes before the hour.
        return next(
            (int) (Double.parseDouble(clock.text(0)) * HOUR - Double.parseDouble(clock.text(1))),
            now);
      case "toquarter":
        return next(hours(clock) - QUARTER, now);
      default:
        return next(hours(clock), now);
    }
  }

  /**
   * The same of what is usually wanted in the morning: of two times that are called the same that
   * of the morning is meant, unless the other one is still to come this afternoon.
   */
  static OptionalInt minuteOfMorning(Form clock, OptionalInt now) {
    OptionalInt next = minuteOfDay(clock, now);
    OptionalInt morning = minuteOfTomorrow(clock);
    return next.isPresent()
            && morning.isPresent()
            && next.getAsInt() == morning.getAsInt() + NOON
            && next.getAsInt() >= EVENING
        ? morning
        : next;
  }

  /** The same of the next day: what may be meant of two times is that of the morning. */
  static OptionalInt minuteOfTomorrow(Form clock) {
    return minuteOfDay(clock, OptionalInt.of(DAY - 1));
  }

  /** Minutes of the hour, and of those that are said after it. */
  private static int hours(Form clock) {
    double more = clock.parts().size() > 1 ? Double.parseDouble(clock.text(1)) : 0;
    return (int) Math.round(Double.parseDouble(clock.text(0)) * HOUR + more);
  }

  private static int time(String written) {
    String[] parts = written.split(":");
    return parts.length == 2
        ? Integer.parseInt(parts[0]) * HOUR + Integer.parseInt(parts[1])
        : Integer.parseInt(written);
  }

  private static OptionalInt inDay(int minutes) {
    return minutes >= 0 && minutes < DAY ? OptionalInt.of(minutes) : OptionalInt.empty();
  }

  /** Of the afternoon, by twelve or by twenty-four hours. */
  private static OptionalInt afternoon(int minutes) {
    return minutes < DAY ? inDay(minutes % NOON + NOON) : OptionalInt.empty();
  }

  private static OptionalInt next(int minutes, OptionalInt now) {
    if (minutes > NOON + HOUR - 1 || now.isEmpty()) {
      return inDay(minutes);
    }
    int morning = minutes % NOON;
    int evening = morning + NOON;
    boolean isEvening = now.getAsInt() >= morning && now.getAsInt() < evening;
    return OptionalInt.of(isEvening ? evening : morning);
  }

  private static OptionalInt inPart(Form clock, OptionalInt now) {
    boolean isMorning = clock.text(0).equals("morning");
    if (clock.parts().size() < 2) {
      return OptionalInt.of(
          isMorning ? 8 * HOUR : clock.text(0).equals("evening") ? 20 * HOUR : NOON);
    }
    if (clock.text(0).equals("any")) {
      return minuteOfTomorrow(clock.part(1));
    }
    OptionalInt said = minuteOfDay(clock.part(1), now);
    if (clock.text(0).equals("night") && said.isPresent() && said.getAsInt() % NOON < DAWN) {
      return OptionalInt.of(said.getAsInt() % NOON);
    }
    return said.isEmpty() ? said : OptionalInt.of(said.getAsInt() % NOON + (isMorning ? 0 : NOON));
  }
}
