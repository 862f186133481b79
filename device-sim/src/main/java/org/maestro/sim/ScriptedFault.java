package org.maestro.sim;

import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;

/**
 * A fault as a scene states it: when, and what. {@code at 30 die}: once, after so many seconds;
 * {@code every 600 freeze 20}: at random, so many seconds apart in the mean; {@code upon adjust lie
 * 1.5}: once, when that happens to the same device ({@link WorldEvent.Kind}).
 *
 * @param seconds after the beginning, or apart in the mean; 0 for an event
 * @param event upon which it happens
 * @param numbers the deed's, as many as it takes
 */
public record ScriptedFault(
    When when, double seconds, Optional<WorldEvent.Kind> event, Deed deed, List<Double> numbers) {

  public ScriptedFault {
    numbers = List.copyOf(numbers);
  }

  /** How the moment is found. */
  public enum When {
    AT,
    EVERY,
    UPON
  }

  /** What happens. */
  public enum Deed {
    DIE(0),
    REVIVE(0),
    /** Every command fails. */
    BREAK(0),
    REPAIR(0),
    /** Commands take effect after so many seconds only. */
    FREEZE(1),
    /** A sensor measures so many times the truth. */
    LIE(1),
    /** A sensor measures by such a share more, every hour. */
    DRIFT(1),
    /** A robot loses what it holds. */
    DROP(0),
    /** A lamp gives such a share of its light. */
    WEAKEN(1),
    /** A zone has so much light besides; lux. */
    AMBIENT(1),
    /** Clouds hide such a share of the sky over the home. */
    CLOUDS(1),
    /** A thing or person stands there; x and y. */
    MOVE(2),
    OPEN(0),
    CLOSE(0);

    private final int numbers;

    Deed(int numbers) {
      this.numbers = numbers;
    }
  }

  /**
   * @throws IllegalArgumentException when the text is none; the message says what is wrong
   */
  static ScriptedFault parse(String text) {
    List<String> words = Arrays.asList(text.strip().split("\\s+"));
    if (words.size() < 3) {
      throw new IllegalArgumentException(
          "write when and what, such as \"at 30 die\", instead of \"" + text.strip() + "\"");
    }
    When when = word(When.class, words.get(0));
    Deed deed = word(Deed.class, words.get(2));
    List<Double> numbers =
        words.subList(3, words.size()).stream().map(ScriptedFault::number).toList();
    if (numbers.size() != deed.numbers) {
      throw new IllegalArgumentException(
          "%s takes %d numbers, not %d".formatted(words.get(2), deed.numbers, numbers.size()));
    }
    return when == When.UPON
        ? new ScriptedFault(
            when, 0, Optional.of(word(WorldEvent.Kind.class, words.get(1))), deed, numbers)
        : new ScriptedFault(when, positive(words.get(1)), Optional.empty(), deed, numbers);
  }

  private static double positive(String word) {
    double number = number(word);
    if (number <= 0) {
      throw new IllegalArgumentException("seconds are more than none, not " + word);
    }
    return number;
  }

  private static double number(String word) {
    try {
      return Double.parseDouble(word);
    } catch (NumberFormatException e) {
      throw new IllegalArgumentException("\"" + word + "\" is no number", e);
    }
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
