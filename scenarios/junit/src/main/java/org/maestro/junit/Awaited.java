package org.maestro.junit;

import java.time.Duration;

/**
 * A sentence that somebody has waited for.
 *
 * @param time that has passed since she said something last, by the stage's clock
 */
public record Awaited(String sentence, Duration time) {
  private static final Duration PRECISION = Duration.ofSeconds(1);

  /**
   * She heard it so long after she had said something last, within a second; else the test fails.
   */
  public Awaited after(Duration expected) {
    if (time.minus(expected).abs().compareTo(PRECISION) > 0) {
      throw new AssertionError(
          "\"%s\" was to be heard after %s, and was after %s".formatted(sentence, expected, time));
    }
    return this;
  }
}
