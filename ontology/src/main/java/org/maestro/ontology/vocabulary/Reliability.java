package org.maestro.ontology.vocabulary;

import java.util.Optional;

/**
 * How often a feature works, and how often it may be tried.
 *
 * @param chance that a call brings about what it is for, above 0 and at most 1; absent: it is
 *     counted on
 * @param statedTries how often in all it may be tried while nothing changes that it rests on;
 *     absent: as its chance asks for
 */
public record Reliability(Optional<Double> chance, Optional<Integer> statedTries) {

  /** Counted on, and tried again when it fails. */
  public static final Reliability USUAL = new Reliability(Optional.empty(), Optional.empty());

  private static final int USUAL_TRIES = 3;
  private static final int MOST_TRIES = 100;

  /** All of the tries fail so rarely, of what works by chance. */
  private static final double ALL_FAIL = 0.01;

  /**
   * How often in all it is tried, the last try included that is kept for when a goal would be given
   * up: 1 to 100.
   */
  public int tries() {
    return statedTries.orElseGet(() -> chance.map(Reliability::triesFor).orElse(USUAL_TRIES));
  }

  private static int triesFor(double chance) {
    if (chance >= 1) {
      return USUAL_TRIES;
    }
    double needed = Math.ceil(Math.log(ALL_FAIL) / Math.log1p(-chance));
    return (int) Math.max(USUAL_TRIES, Math.min(MOST_TRIES, needed));
  }

  /** How often it is to be called in the mean until it works; 1 when it is counted on. */
  public double expectedCalls() {
    return 1 / chance.orElse(1.0);
  }

  /** What differs from the other. */
  Reliability or(Reliability other) {
    return new Reliability(chance.or(other::chance), statedTries.or(other::statedTries));
  }
}
