package org.maestro.sim.scene;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A fault as a scene states it: when, and what ({@link Deed}). {@code at 30 die}: once, after so
 * many seconds; {@code every 600 freeze 20}: at random, so many seconds apart in the mean; {@code
 * upon adjust lie 1.5}: once, when that happens to the same device ({@link WorldEvent.Kind});
 * {@code upon rose.picked block door-ab}: when it happens to another.
 *
 * @param seconds after the beginning, or apart in the mean; 0 for an event
 * @param cause the event upon which it happens
 * @param numbers the deed's, as many as it takes
 * @param name the deed's, if it takes one
 */
public record ScriptedFault(
    When when,
    double seconds,
    Optional<Cause> cause,
    Deed deed,
    List<Double> numbers,
    Optional<String> name) {

  public ScriptedFault {
    numbers = List.copyOf(numbers);
  }

  /** The way in which the moment of a fault is found: a time, chance, or an event. */
  public enum When {
    AT,
    EVERY,
    UPON
  }

  /**
   * An event.
   *
   * @param subject of whom; empty: of the one to whom the fault happens
   */
  public record Cause(Optional<String> subject, WorldEvent.Kind kind) {}

  /**
   * Reads one, such as {@code at 30 die}.
   *
   * @throws IllegalArgumentException when the text is none; the message says what is wrong
   */
  public static ScriptedFault parse(String text) {
    List<String> words = Arrays.asList(text.strip().split("\\s+"));
    if (words.size() < 3) {
      throw new IllegalArgumentException(
          "write when and what, such as \"at 30 die\", instead of \"" + text.strip() + "\"");
    }
    When when = word(When.class, words.get(0));
    Deed deed = word(Deed.class, words.get(2));
    List<String> given = words.subList(3, words.size());
    if (given.size() != deed.arguments().size()) {
      throw new IllegalArgumentException(
          "%s takes %s, not %d".formatted(words.get(2), count(deed.arguments()), given.size()));
    }
    List<Double> numbers = new ArrayList<>();
    Optional<String> name = Optional.empty();
    for (int i = 0; i < given.size(); i++) {
      if (deed.arguments().get(i) == Deed.Argument.NAME) {
        name = Optional.of(given.get(i));
      } else {
        numbers.add(number(given.get(i), deed.arguments().get(i)));
      }
    }
    return when == When.UPON
        ? new ScriptedFault(when, 0, Optional.of(cause(words.get(1))), deed, numbers, name)
        : new ScriptedFault(when, seconds(words.get(1)), Optional.empty(), deed, numbers, name);
  }

  private static String count(List<Deed.Argument> arguments) {
    return arguments.contains(Deed.Argument.NAME) ? "1 name" : arguments.size() + " numbers";
  }

  private static Cause cause(String word) {
    int dot = word.indexOf('.');
    return new Cause(
        dot < 0 ? Optional.empty() : Optional.of(word.substring(0, dot)),
        word(WorldEvent.Kind.class, word.substring(dot + 1)));
  }

  private static double seconds(String word) {
    double number = number(word);
    if (number <= 0) {
      throw new IllegalArgumentException("seconds are more than none, not " + word);
    }
    return number;
  }

  private static double number(String word, Deed.Argument kind) {
    double number = number(word);
    if (kind != Deed.Argument.ANY_NUMBER && number < 0
        || kind == Deed.Argument.SHARE && number > 1) {
      throw new IllegalArgumentException(
          "%s is not %s"
              .formatted(
                  word, kind == Deed.Argument.SHARE ? "between 0 and 1" : "a number from 0 on"));
    }
    return number;
  }

  private static double number(String word) {
    try {
      double number = Double.parseDouble(word);
      if (Double.isFinite(number)) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("\"" + word + "\" is no number", e);
    }
    throw new IllegalArgumentException("\"" + word + "\" is no number");
  }

  private static <E extends Enum<E>> E word(Class<E> kind, String word) {
    Map<String, E> known = new TreeMap<>();
    for (E constant : kind.getEnumConstants()) {
      known.put(constant.name().toLowerCase(Locale.ROOT), constant);
    }
    return Optional.ofNullable(known.get(word))
        .orElseThrow(
            () ->
                new IllegalArgumentException(
                    "\"%s\" is not known; known are %s"
                        .formatted(word, String.join(", ", known.keySet()))));
  }
}
