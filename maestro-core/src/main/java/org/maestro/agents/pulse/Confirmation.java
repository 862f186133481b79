package org.maestro.agents.pulse;

import java.time.Duration;

/**
 * The answer to a sign of life.
 *
 * @param welcome false when the container was given up, and has to join again
 * @param period until the next one
 * @param lease for so long the container may act
 */
record Confirmation(boolean welcome, Duration period, Duration lease) {

  static Confirmation of(HeartbeatSettings settings, boolean welcome) {
    return new Confirmation(welcome, settings.period(), settings.lease());
  }

  String write() {
    return "%b %d %d".formatted(welcome, period.toMillis(), lease.toMillis());
  }

  /**
   * @throws IllegalArgumentException when it is none
   */
  static Confirmation read(String text) {
    String[] words = text.split(" ");
    if (words.length != 3) {
      throw new IllegalArgumentException("\"" + text + "\" confirms no sign of life.");
    }
    return new Confirmation(Boolean.parseBoolean(words[0]), millis(words[1]), millis(words[2]));
  }

  private static Duration millis(String word) {
    return Duration.ofMillis(Long.parseLong(word));
  }
}
