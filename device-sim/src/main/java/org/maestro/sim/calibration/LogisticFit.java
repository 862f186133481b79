package org.maestro.sim.calibration;

import java.util.List;

/**
 * The logistic function of light that comes nearest to what was seen, by least squares.
 *
 * @param halfLux light in which half of the frames show the thing
 * @param slopeLux steepness around that; below 0 where more light shows less
 */
public record LogisticFit(double halfLux, double slopeLux) {

  private static final int STEPS = 40;
  private static final int ROUNDS = 5;

  /** Slopes as shares of the light around which they are. */
  private static final double STEEPEST = 0.01;

  private static final double FLATTEST = 1;

  /** The share of frames that show it in light that is fit. */
  static final double FIT_RATE = 0.98;

  /**
   * @param levels at least one
   * @param rising whether more light shows more
   */
  static LogisticFit of(List<LightLevel> levels, boolean rising) {
    double low = levels.stream().mapToDouble(LightLevel::lux).min().orElseThrow();
    double high = levels.stream().mapToDouble(LightLevel::lux).max().orElseThrow();
    double steepest = STEEPEST;
    double flattest = FLATTEST;
    LogisticFit best = new LogisticFit(low, rising ? low : -low);
    for (int round = 0; round < ROUNDS; round++) {
      double halfStep = Math.pow(high / low, 1.0 / STEPS);
      double slopeStep = Math.pow(flattest / steepest, 1.0 / STEPS);
      for (int i = 0; i <= STEPS; i++) {
        for (int j = 0; j <= STEPS; j++) {
          double half = low * Math.pow(halfStep, i);
          double slope = half * steepest * Math.pow(slopeStep, j);
          LogisticFit next = new LogisticFit(half, rising ? slope : -slope);
          if (next.error(levels) < best.error(levels)) {
            best = next;
          }
        }
      }
      double share = Math.abs(best.slopeLux) / best.halfLux;
      low = best.halfLux / halfStep;
      high = best.halfLux * halfStep;
      steepest = Math.max(STEEPEST, share / slopeStep);
      flattest = Math.min(FLATTEST, share * slopeStep);
    }
    return best;
  }

  /** The share of frames that it says show the thing. */
  public double rate(double lux) {
    return 1 / (1 + Math.exp(-(lux - halfLux) / slopeLux));
  }

  /** Light from which, or up to which, nearly all frames show it by this function; from 0 on. */
  public double fitLux() {
    return Math.max(0, halfLux + slopeLux * Math.log(FIT_RATE / (1 - FIT_RATE)));
  }

  /** Root of the mean square of what it errs by. */
  public double error(List<LightLevel> levels) {
    return Math.sqrt(
        levels.stream()
            .mapToDouble(level -> Math.pow(level.rate() - rate(level.lux()), 2))
            .average()
            .orElse(0));
  }

  /** The most that it errs by in any light. */
  public double greatestError(List<LightLevel> levels) {
    return levels.stream()
        .mapToDouble(level -> Math.abs(level.rate() - rate(level.lux())))
        .max()
        .orElse(0);
  }
}
