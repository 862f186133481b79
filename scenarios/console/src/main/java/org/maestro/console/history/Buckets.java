package org.maestro.console.history;

import java.util.Arrays;
import java.util.List;

/**
 * A series as so many parts of equal length of a span: of each the lowest, the mean and the highest
 * value that it had in it, so that a peak is seen however short it was. Where nothing was known it
 * is not a number.
 */
final class Buckets {
  private final long from;
  private final double length;
  private final double[] low;
  private final double[] high;
  private final double[] sum;
  private final double[] known;

  private Buckets(long from, long to, int number) {
    this.from = from;
    this.length = Math.max(1, to - from) / (double) number;
    this.low = filled(number, Double.POSITIVE_INFINITY);
    this.high = filled(number, Double.NEGATIVE_INFINITY);
    this.sum = new double[number];
    this.known = new double[number];
  }

  /**
   * Sorts samples into them.
   *
   * @param samples oldest first; those before the span tell what was so at its begin
   * @param from milliseconds of the wall's clock
   * @param to not among them any more
   * @param until when the last one was so still
   */
  static Buckets of(List<Sample> samples, long from, long to, long until, int number) {
    Buckets buckets = new Buckets(from, to, number);
    for (int i = 0; i < samples.size(); i++) {
      Sample sample = samples.get(i);
      long end = i + 1 < samples.size() ? samples.get(i + 1).at() : Math.max(until, sample.at());
      if (sample.isKnown() && (end > from || sample.at() >= from) && sample.at() < to) {
        buckets.add(sample, Math.max(from, sample.at()), Math.min(to, end));
      }
    }
    return buckets;
  }

  private static double[] filled(int number, double with) {
    double[] values = new double[number];
    Arrays.fill(values, with);
    return values;
  }

  private void add(Sample sample, long begin, long end) {
    for (int i = index(begin); i < low.length && (begin(i) < end || i == index(begin)); i++) {
      double weight = Math.min((double) end, begin(i + 1)) - Math.max((double) begin, begin(i));
      low[i] = Math.min(low[i], sample.low());
      high[i] = Math.max(high[i], sample.high());
      // What was so for no time at all is seen all the same.
      double least = Math.max(weight, 1e-6);
      sum[i] += sample.mean() * least;
      known[i] += least;
    }
  }

  private int index(long at) {
    return Math.min(low.length - 1, (int) ((at - from) / length));
  }

  private double begin(int i) {
    return from + i * length;
  }

  int number() {
    return low.length;
  }

  boolean isKnown(int i) {
    return known[i] > 0;
  }

  double low(int i) {
    return low[i];
  }

  /** Never beyond the lowest and the highest, as sums of fractions may come out. */
  double mean(int i) {
    return Math.max(low[i], Math.min(high[i], sum[i] / known[i]));
  }

  double high(int i) {
    return high[i];
  }
}
