package org.maestro.random;

import java.util.List;
import java.util.Random;

/** Draws of one seed, in a fixed order. */
final class Chance {
  private static final long SPREAD = 0x9E3779B97F4A7C15L;

  private final Random random;

  Chance(long seed) {
    this.random = new Random(seed * SPREAD);
  }

  boolean happens(double probability) {
    return random.nextDouble() < probability;
  }

  /** Both ends included. */
  int whole(int least, int greatest) {
    return least + random.nextInt(greatest - least + 1);
  }

  /** A number on a grid of hundredths. */
  double number(double least, double greatest) {
    return Math.round(100 * (least + random.nextDouble() * (greatest - least))) / 100.0;
  }

  <T> T oneOf(List<T> choices) {
    return choices.get(random.nextInt(choices.size()));
  }
}
