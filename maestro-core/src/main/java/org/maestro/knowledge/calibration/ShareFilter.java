package org.maestro.knowledge.calibration;

import java.util.List;

/**
 * A Kalman filter for a number that is the sum of shares, each times its setting, and of a rest
 * that rises or falls, and wanders: from what is measured after settings have changed it learns the
 * shares. It starts from what is stated of them. Confined to one thread.
 */
final class ShareFilter {
  /** How far from what is stated a share is expected to be; of that. Assumption. */
  private static final double DOUBT = 0.5;

  /** Standard deviation of a measurement, of the value, and of the largest share. Assumption. */
  private static final double NOISE = 0.02;

  private static final double GRAIN = 0.002;

  /** The least, and the first, by which the rest wanders in a second; of the largest share. */
  private static final double CALM = 0.001;

  private static final double USUAL_WANDER = 0.05;

  /** How fast the rest rises or falls, as at dawn, and how that changes in a second; the same. */
  private static final double TREND = 0.01;

  private static final double TURN = 0.001;

  /** The places of the rest, of its trend, and of the first share in estimates. */
  private static final int REST = 0;

  private static final int TREND_OF_REST = 1;
  private static final int SHARES = 2;

  /** By so many standard deviations nothing is off that is as before. */
  private static final double FAR = 4;

  /** What differs by more standard deviations of chance than these is no chance. */
  private static final double CERTAIN = 3;

  /** The least difference, of what is stated, that is worth a word. */
  private static final double WORTH_TELLING = 0.1;

  /** A single change may be of what was done beside it. */
  private static final int ENOUGH = 2;

  /** A new wander is weighed so much against what was counted of it before. */
  private static final double NEWS = 0.2;

  /** The same of what is more than so many times what was to be expected, where it is not clear. */
  private static final double FAR_NEWS = 0.5;

  private static final double UNUSUAL = 4;

  /** A single surprise does not count for more than so many times what was to be expected. */
  private static final double MOST = 30;

  private static final double SAME = 1e-6;

  private final double[] stated;
  private final double scale;
  private final double[] estimate;

  /** How unsure the estimate is. */
  private final double[][] doubt;

  /** How far the estimate varies by the noise alone, if all were as stated. */
  private final double[][] chance;

  private final double[] settings;

  /** After how many changes of its setting something was measured. */
  private final int[] changes;

  private double wander;
  private boolean isFirst = true;

  /**
   * @param stated what each setting gives when it is 1; not 0
   */
  ShareFilter(double[] stated) {
    int size = stated.length + SHARES;
    this.stated = stated.clone();
    double largest = 0;
    for (double share : stated) {
      largest = Math.max(largest, Math.abs(share));
    }
    this.scale = largest;
    this.estimate = new double[size];
    this.doubt = new double[size][size];
    this.chance = new double[size][size];
    this.settings = new double[stated.length];
    this.changes = new int[stated.length];
    this.wander = square(USUAL_WANDER * scale);
    for (int part = 0; part < stated.length; part++) {
      restart(part);
    }
    forgetRest();
  }

  /** Of the share nothing is known but what is stated. */
  void restart(int part) {
    asStated(part);
    if (settings[part] != 0) {
      forgetRest();
    }
  }

  private void asStated(int part) {
    int at = part + SHARES;
    clear(doubt, at);
    clear(chance, at);
    estimate[at] = stated[part];
    changes[part] = 0;
    doubt[at][at] = square(DOUBT * stated[part]);
  }

  /** Something else has changed the number: what the rest was does not count any more. */
  void forgetRest() {
    for (double[][] matrix : List.of(doubt, chance)) {
      clear(matrix, REST);
      clear(matrix, TREND_OF_REST);
      matrix[REST][REST] = square(1e4 * scale);
      matrix[TREND_OF_REST][TREND_OF_REST] = square(TREND * scale);
    }
    estimate[TREND_OF_REST] = 0;
  }

  private static void clear(double[][] matrix, int at) {
    for (int n = 0; n < matrix.length; n++) {
      matrix[at][n] = 0;
      matrix[n][at] = 0;
    }
  }

  /**
   * Learns from a measurement.
   *
   * @param seconds since the one before
   * @param now the settings at that time
   */
  void measured(double seconds, double[] now, double number) {
    estimate[REST] += seconds * estimate[TREND_OF_REST];
    passed(doubt, seconds);
    passed(chance, seconds);
    double noise = square(NOISE * number) + square(GRAIN * scale);
    double error = number - expected(now);
    double variance = variance(doubt, now) + noise;
    if (!isFirst) {
      wandered(square(error), variance, seconds);
    }
    if (square(error) > square(FAR) * variance) {
      surprised(now);
      error = number - expected(now);
      variance = variance(doubt, now) + noise;
    }
    correct(now, error, variance, noise);
    for (int part = 0; part < now.length; part++) {
      changes[part] += !isFirst && hasChanged(now, part) ? 1 : 0;
    }
    System.arraycopy(now, 0, settings, 0, now.length);
    isFirst = false;
  }

  /** What is not explained by all else is, the more of it may come from there, the rest's. */
  private void wandered(double squaredError, double variance, double seconds) {
    double own = wander * seconds;
    double seen = Math.max(0, Math.min(squaredError, MOST * variance) - (variance - own));
    if (seconds > 0) {
      double weight =
          NEWS * Math.max(own / variance, squaredError > UNUSUAL * variance ? FAR_NEWS : 0);
      wander = Math.max(square(CALM * scale), wander + weight * (seen / seconds - wander));
    }
  }

  /** In that time the rest goes on as it went, or turns, or wanders. */
  private void passed(double[][] matrix, double seconds) {
    for (int n = 0; n < matrix.length; n++) {
      matrix[REST][n] += seconds * matrix[TREND_OF_REST][n];
    }
    for (int n = 0; n < matrix.length; n++) {
      matrix[n][REST] += seconds * matrix[n][TREND_OF_REST];
    }
    matrix[REST][REST] += wander * seconds;
    matrix[TREND_OF_REST][TREND_OF_REST] += square(TURN * scale) * seconds;
  }

  private boolean hasChanged(double[] now, int part) {
    return Math.abs(now[part] - settings[part]) > SAME;
  }

  /** What was set is no longer as it was learnt; or it was none of what is set. */
  private void surprised(double[] now) {
    boolean any = false;
    for (int part = 0; part < now.length; part++) {
      if (hasChanged(now, part)) {
        asStated(part);
        any = true;
      }
    }
    if (!any) {
      forgetRest();
    }
  }

  private double expected(double[] now) {
    double sum = estimate[REST];
    for (int part = 0; part < now.length; part++) {
      sum += now[part] * estimate[part + SHARES];
    }
    return sum;
  }

  private static double variance(double[][] matrix, double[] now) {
    double[] column = times(matrix, now);
    double variance = column[REST];
    for (int part = 0; part < now.length; part++) {
      variance += now[part] * column[part + SHARES];
    }
    return variance;
  }

  /** The matrix times the measurement's row, in which the rest counts once. */
  private static double[] times(double[][] matrix, double[] now) {
    double[] column = new double[matrix.length];
    for (int n = 0; n < matrix.length; n++) {
      column[n] = matrix[n][REST];
      for (int part = 0; part < now.length; part++) {
        column[n] += matrix[n][part + SHARES] * now[part];
      }
    }
    return column;
  }

  private void correct(double[] now, double error, double variance, double noise) {
    double[] gain = times(doubt, now);
    for (int n = 0; n < gain.length; n++) {
      gain[n] /= variance;
      estimate[n] += gain[n] * error;
    }
    joseph(doubt, gain, now, noise);
    joseph(chance, gain, now, noise);
  }

  /** (I - K h) M (I - K h)' + K r K', which stays symmetrical and is right for any gain. */
  private static void joseph(double[][] matrix, double[] gain, double[] now, double noise) {
    double[] column = times(matrix, now);
    double variance = variance(matrix, now) + noise;
    int size = gain.length;
    for (int n = 0; n < size; n++) {
      for (int m = 0; m < size; m++) {
        matrix[n][m] += gain[n] * gain[m] * variance - gain[n] * column[m] - column[n] * gain[m];
      }
    }
  }

  /** What the setting gives when it is 1, as far as is known. */
  double share(int part) {
    return estimate[part + SHARES];
  }

  /** Whether that is otherwise than stated, by more than chance and by enough to matter. */
  boolean isOtherwise(int part) {
    double difference = Math.abs(estimate[part + SHARES] - stated[part]);
    return changes[part] >= ENOUGH
        && difference >= WORTH_TELLING * Math.abs(stated[part])
        && difference >= CERTAIN * Math.sqrt(Math.max(0, chance[part + SHARES][part + SHARES]));
  }

  /** Whether the difference does not matter any more. */
  boolean isAsStated(int part) {
    return Math.abs(estimate[part + SHARES] - stated[part])
        < WORTH_TELLING / 2 * Math.abs(stated[part]);
  }

  private static double square(double value) {
    return value * value;
  }
}
