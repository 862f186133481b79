package org.maestro.sim.scene;

import java.time.Duration;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * Something that a person says at a time.
 *
 * @param at counted from the beginning
 */
public record Saying(Duration at, String words) {
  private static final Pattern WRITTEN = Pattern.compile("at ([0-9]+(?:[.][0-9]+)?) (\\S.*)");
  private static final double MILLIS_PER_SECOND = 1_000;

  /**
   * Reads {@code at 12 turn on the light}.
   *
   * @throws IllegalArgumentException when it is something else
   */
  static Saying parse(String text) {
    Matcher written = WRITTEN.matcher(text.strip());
    if (!written.matches()) {
      throw new IllegalArgumentException(
          "\"%s\" does not say when what is said; write it as in \"at 12 turn on the light\"."
              .formatted(text.strip()));
    }
    double seconds = Double.parseDouble(written.group(1));
    return new Saying(Duration.ofMillis(Math.round(seconds * MILLIS_PER_SECOND)), written.group(2));
  }
}
