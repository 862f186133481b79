package org.maestro.sim.sky;

import java.time.Duration;

/**
 * Clouds that come and go: their share of the sky changes evenly from one random value to the next.
 * A value depends on the seed and its number alone, so that any moment can be asked for.
 *
 * @param cover mean share of the sky, 0 to 1
 * @param change greatest difference from the mean; what would be below 0 or above 1 is cut off
 * @param every time between two random values
 */
public record Clouds(double cover, double change, Duration every, long seed) {

  public static final Clouds NONE = new Clouds(0, 0, Duration.ofMinutes(10), 0);

  private static final long GOLDEN = 0x9E3779B97F4A7C15L;
  private static final long FIRST_MIX = 0xBF58476D1CE4E5B9L;
  private static final long SECOND_MIX = 0x94D049BB133111EBL;
  private static final double LARGEST = 1L << 53;

  public Clouds {
    if (every.isZero() || every.isNegative()) {
      throw new IllegalArgumentException("Clouds change after some time, not after " + every + ".");
    }
  }

  /** The same clouds all the time. */
  public static Clouds steady(double cover) {
    return new Clouds(cover, 0, NONE.every(), 0);
  }

  /** The share of the sky that they hide, 0 to 1. */
  public double at(Duration time) {
    if (change == 0) {
      return cover;
    }
    double steps = (double) time.toMillis() / every.toMillis();
    long number = (long) Math.floor(steps);
    double share = steps - number;
    double deviation = (1 - share) * random(number) + share * random(number + 1);
    return Math.max(0, Math.min(1, cover + change * deviation));
  }

  /** From -1 to 1, evenly spread: SplitMix64 (Steele, Lea and Flood 2014). */
  private double random(long number) {
    long mixed = seed + (number + 1) * GOLDEN;
    mixed = (mixed ^ mixed >>> 30) * FIRST_MIX;
    mixed = (mixed ^ mixed >>> 27) * SECOND_MIX;
    mixed ^= mixed >>> 31;
    return 2 * ((mixed >>> 11) / LARGEST) - 1;
  }
}
