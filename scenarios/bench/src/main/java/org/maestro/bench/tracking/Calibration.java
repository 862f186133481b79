package org.maestro.bench.tracking;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;

/** How often what was told with a confidence was so, by confidence. For one thread. */
final class Calibration {
  private static final double[] FROM = {0.5, 0.6, 0.7, 0.8, 0.9, 0.95, 1.0001};

  private final long[] told = new long[FROM.length - 1];
  private final long[] right = new long[FROM.length - 1];
  private final double[] confidence = new double[FROM.length - 1];
  private double squares;

  void add(double sureness, boolean isSo) {
    int bin = bin(sureness);
    told[bin]++;
    right[bin] += isSo ? 1 : 0;
    confidence[bin] += sureness;
    squares += Math.pow(sureness - (isSo ? 1 : 0), 2);
  }

  private static int bin(double sureness) {
    int bin = 0;
    while (bin < FROM.length - 2 && sureness >= FROM[bin + 1]) {
      bin++;
    }
    return bin;
  }

  private long all() {
    return IntStream.range(0, told.length).mapToLong(bin -> told[bin]).sum();
  }

  /** The mean of the squared distances between what was told and what was so: 0 is perfect. */
  double brier() {
    return all() == 0 ? Double.NaN : squares / all();
  }

  /** The mean distance between how sure one was and how often that was so. */
  double error() {
    double sum = 0;
    for (int bin = 0; bin < told.length; bin++) {
      sum += Math.abs(confidence[bin] - right[bin]);
    }
    return all() == 0 ? Double.NaN : sum / all();
  }

  /** A line for each range of confidence in which something was told. */
  List<String> lines() {
    List<String> lines = new ArrayList<>();
    for (int bin = 0; bin < told.length; bin++) {
      if (told[bin] > 0) {
        lines.add(
            String.format(
                Locale.ROOT,
                "told with %.2f to %.2f, %.3f in the mean: so in %.3f of %d cases",
                FROM[bin],
                Math.min(1, FROM[bin + 1]),
                confidence[bin] / told[bin],
                (double) right[bin] / told[bin],
                told[bin]));
      }
    }
    return lines;
  }
}
