package org.maestro.console.history;

/**
 * What a series was from a moment until its next sample; not a number where nobody knows.
 *
 * @param at milliseconds of the wall's clock
 * @param low the lowest of what it stands for
 * @param high the highest
 */
record Sample(long at, double low, double mean, double high) {

  static Sample of(long at, double value) {
    return new Sample(at, value, value, value);
  }

  static Sample unknown(long at) {
    return of(at, Double.NaN);
  }

  boolean isKnown() {
    return !Double.isNaN(mean);
  }
}
