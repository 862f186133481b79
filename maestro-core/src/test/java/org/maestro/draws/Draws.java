package org.maestro.draws;

import java.util.List;
import java.util.Random;

/**
 * Chance as a list of draws: where it ends, each further draw is 0, so that a shorter list and
 * smaller numbers are a simpler case. Who draws on and on gets pseudo-random numbers at last, as
 * some loops wait for one that fits.
 */
final class Draws extends Random {
  private static final long serialVersionUID = 1L;
  private static final int MOST_ZEROS = 10_000;

  private final transient List<Integer> draws;
  private int drawn;

  Draws(List<Integer> draws) {
    super(0);
    this.draws = draws;
  }

  @Override
  protected int next(int bits) {
    if (draws == null || drawn >= draws.size() + MOST_ZEROS) {
      return super.next(bits);
    }
    int draw = drawn < draws.size() ? draws.get(drawn) : 0;
    drawn++;
    return draw >>> (Integer.SIZE - bits);
  }

  /** All that may be drawn, also of one that was not used yet. */
  @Override
  public String toString() {
    return draws.size() + " draws: " + draws;
  }
}
