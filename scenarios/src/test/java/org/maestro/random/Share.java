package org.maestro.random;

import java.util.stream.LongStream;

/**
 * The seeds that one run of the tests takes on where several runs share them: with {@code
 * -Dmaestro.share=2/3} each third one. The same seed gives the same story, so a second run of it
 * would show nothing new.
 */
public final class Share {
  private static final String PROPERTY = "maestro.share";

  private Share() {}

  /** Those of all seeds that fall to this run: all of them, where nothing is said. */
  public static LongStream of(LongStream seeds) {
    String text = System.getProperty(PROPERTY, "1/1");
    String[] parts = text.split("/");
    if (parts.length != 2) {
      throw new IllegalArgumentException(
          "-D%s=%s: needed is which run of how many, as in 2/3.".formatted(PROPERTY, text));
    }
    long number = Long.parseLong(parts[0]);
    long runs = Long.parseLong(parts[1]);
    return seeds.filter(seed -> Math.floorMod(seed, runs) == Math.floorMod(number, runs));
  }
}
