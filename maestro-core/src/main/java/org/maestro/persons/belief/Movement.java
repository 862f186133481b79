package org.maestro.persons.belief;

import java.time.Duration;

/**
 * The movement of a person whom nobody sees: she leaves each place at a constant rate, by one way
 * as likely as by another. What is so after some time is reckoned by uniformization (Jensen 1953),
 * to twelve digits. Immutable.
 */
public final class Movement {
  private static final double NANOS = 1e9;
  private static final double ACCURACY = 1e-12;

  /** After so many stays nothing changes any more that could be told. */
  private static final double MOST_JUMPS = 200;

  private final Places places;
  private final double[] rates;
  private final double fastest;

  /**
   * A movement.
   *
   * @param stay how long one stays in a zone in the mean, more than nothing
   * @param absence how long one stays away in the mean, more than nothing
   */
  public Movement(Places places, Duration stay, Duration absence) {
    this.places = places;
    this.rates = new double[places.size()];
    double most = 0;
    for (int place = 0; place < rates.length; place++) {
      double seconds = seconds(place == places.away() ? absence : stay);
      rates[place] = places.beside(place).length == 0 ? 0 : 1 / seconds;
      most = Math.max(most, rates[place]);
    }
    this.fastest = most;
  }

  Places places() {
    return places;
  }

  /** How likely one is in each place after this time, by where one was before. */
  double[][] chances(Duration time) {
    double[][] chances = new double[rates.length][];
    for (int from = 0; from < rates.length; from++) {
      double[] there = new double[rates.length];
      there[from] = 1;
      chances[from] = after(there, time);
    }
    return chances;
  }

  /** What becomes of probabilities, one for each place, in this time; their sum stays. */
  double[] after(double[] before, Duration time) {
    double jumps = Math.min(MOST_JUMPS, fastest * seconds(time));
    if (jumps <= 0) {
      return before;
    }
    double[] after = new double[before.length];
    double[] now = before;
    double weight = Math.exp(-jumps);
    double left = 1 - weight;
    add(after, now, weight);
    for (int jump = 1; left > ACCURACY && jump < 10 * MOST_JUMPS; jump++) {
      now = jumped(now);
      weight *= jumps / jump;
      left -= weight;
      add(after, now, weight);
    }
    add(after, now, Math.max(0, left));
    return after;
  }

  private double[] jumped(double[] before) {
    double[] after = new double[before.length];
    for (int place = 0; place < before.length; place++) {
      double leaving = before[place] * rates[place] / fastest;
      after[place] += before[place] - leaving;
      int[] ways = places.beside(place);
      for (int next : ways) {
        after[next] += leaving / ways.length;
      }
    }
    return after;
  }

  private static void add(double[] sum, double[] part, double weight) {
    for (int place = 0; place < sum.length; place++) {
      sum[place] += weight * part[place];
    }
  }

  private static double seconds(Duration time) {
    return time.getSeconds() + time.getNano() / NANOS;
  }
}
