package org.maestro.sim.scene;

import java.time.Duration;
import java.time.LocalTime;
import java.time.format.DateTimeParseException;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.OptionalLong;
import java.util.TreeMap;
import java.util.function.BiFunction;

/** Reads what a scene says of the home itself: the sky over it. */
final class SkyReader {

  private static final String WORDS =
      "latitude, dayOfYear, solarTime, north, cloudCover, cloudChange, cloudMinutes, cloudSeed,"
          + " celsius";
  private static final double NORTH_ABOVE = 90;
  private static final double USUAL_CLOUD_MINUTES = 10;
  private static final double SECONDS_PER_HOUR = 3600;

  private final Map<String, String> left;
  private final BiFunction<String, String, RuntimeException> fault;

  private SkyReader(Map<String, String> said, BiFunction<String, String, RuntimeException> fault) {
    this.left = new TreeMap<>(said);
    this.fault = fault;
  }

  /**
   * @param fault makes an exception of a word and of what is wrong with it, to be thrown when the
   *     word is unknown, missing, or its value makes no sense
   */
  static SceneSky read(
      Map<String, String> said, BiFunction<String, String, RuntimeException> fault) {
    return new SkyReader(said, fault).read();
  }

  private SceneSky read() {
    OptionalLong seed =
        left.containsKey("cloudSeed")
            ? OptionalLong.of((long) number("cloudSeed", 0, 0, Integer.MAX_VALUE))
            : OptionalLong.empty();
    OptionalDouble celsius =
        left.containsKey("celsius")
            ? OptionalDouble.of(number("celsius", 0, -60, 60))
            : OptionalDouble.empty();
    SceneSky sky =
        new SceneSky(
            needed("latitude", -90, 90),
            (int) needed("dayOfYear", 1, 366),
            solarHours(),
            number("north", NORTH_ABOVE, -360, 360),
            number("cloudCover", 0, 0, 1),
            number("cloudChange", 0, 0, 1),
            Duration.ofSeconds(
                Math.round(60 * number("cloudMinutes", USUAL_CLOUD_MINUTES, 0.1, 1440))),
            seed,
            celsius);
    if (!left.isEmpty()) {
      String word = left.keySet().iterator().next();
      throw fault.apply(word, "says scene:%s of the home; known are %s".formatted(word, WORDS));
    }
    return sky;
  }

  private double solarHours() {
    String text = wanted("solarTime");
    try {
      return LocalTime.parse(text).toSecondOfDay() / SECONDS_PER_HOUR;
    } catch (DateTimeParseException e) {
      throw fault.apply(
          "solarTime",
          "gives the home the scene:solarTime \"%s\"; write hours and minutes, such as \"06:30\""
              .formatted(text));
    }
  }

  private double needed(String word, double least, double greatest) {
    return parsed(word, wanted(word), least, greatest);
  }

  private String wanted(String word) {
    String text = left.remove(word);
    if (text == null) {
      throw fault.apply(word, "says something of the sky, but not scene:" + word + "; add it");
    }
    return text;
  }

  private double number(String word, double otherwise, double least, double greatest) {
    String text = left.remove(word);
    return text == null ? otherwise : parsed(word, text, least, greatest);
  }

  private double parsed(String word, String text, double least, double greatest) {
    try {
      double number = Double.parseDouble(text);
      if (number >= least && number <= greatest) {
        return number;
      }
    } catch (NumberFormatException e) {
      throw fault.apply(
          word,
          "gives the home the scene:%s \"%s\", which is no number; write one"
              .formatted(word, text));
    }
    throw fault.apply(
        word,
        "gives the home the scene:%s %s; it lies between %s and %s"
            .formatted(word, text, least, greatest));
  }
}
