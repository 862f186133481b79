package org.maestro.rats.conformance;

import java.time.Duration;

/**
 * How long an examiner waits, on the wall.
 *
 * @param appearsWithin for what is retained
 * @param answersWithin for an answer that has to come
 * @param silence for one that must not come
 */
public record Patience(Duration appearsWithin, Duration answersWithin, Duration silence) {

  /** With devices and brokers that may be slow. */
  public static final Patience USUAL =
      new Patience(Duration.ofSeconds(10), Duration.ofSeconds(5), Duration.ofSeconds(1));
}
