package org.maestro.experiment.measuring;

import java.util.Arrays;

/**
 * Mean of values and how they spread.
 *
 * @param deviation of a sample (n - 1); 0 for fewer than two values
 */
public record Spread(int count, double mean, double deviation, double least, double greatest) {

  /** All but the count are NaN for no values. */
  public static Spread of(double... values) {
    if (values.length == 0) {
      return new Spread(0, Double.NaN, Double.NaN, Double.NaN, Double.NaN);
    }
    double mean = Arrays.stream(values).average().orElseThrow();
    double squares = Arrays.stream(values).map(v -> (v - mean) * (v - mean)).sum();
    double deviation = values.length < 2 ? 0 : Math.sqrt(squares / (values.length - 1));
    return new Spread(
        values.length,
        mean,
        deviation,
        Arrays.stream(values).min().orElseThrow(),
        Arrays.stream(values).max().orElseThrow());
  }
}
