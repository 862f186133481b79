package org.maestro.sim.image;

import java.util.function.DoubleBinaryOperator;

/** The light upon the floor, measured on a grid and even between its points. Immutable. */
public final class LitFloor {

  private final double left;
  private final double lower;
  private final double step;
  private final int columns;
  private final int rows;
  private final double[] lux;

  private LitFloor(double left, double lower, double step, int columns, int rows, double[] lux) {
    this.left = left;
    this.lower = lower;
    this.step = step;
    this.columns = columns;
    this.rows = rows;
    this.lux = lux;
  }

  /**
   * Measures a rectangle.
   *
   * @param step between two points of the grid; metres
   * @param light lux at x and y
   */
  public static LitFloor measured(
      double left,
      double lower,
      double right,
      double upper,
      double step,
      DoubleBinaryOperator light) {
    int columns = (int) Math.ceil((right - left) / step) + 1;
    int rows = (int) Math.ceil((upper - lower) / step) + 1;
    double[] lux = new double[columns * rows];
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        // a point on a wall belongs to neither side
        double x = Math.min(right - step / 10, Math.max(left + step / 10, left + column * step));
        double y = Math.min(upper - step / 10, Math.max(lower + step / 10, lower + row * step));
        lux[row * columns + column] = light.applyAsDouble(x, y);
      }
    }
    return new LitFloor(left, lower, step, columns, rows, lux);
  }

  /** Outside of the rectangle: as at its edge. */
  double lux(double x, double y) {
    double column = Math.max(0, Math.min(columns - 1.000001, (x - left) / step));
    double row = Math.max(0, Math.min(rows - 1.000001, (y - lower) / step));
    int c = (int) column;
    int r = (int) row;
    double right = column - c;
    double up = row - r;
    int at = r * columns + c;
    int above = r + 1 < rows ? at + columns : at;
    int beside = c + 1 < columns ? 1 : 0;
    return (1 - up) * ((1 - right) * lux[at] + right * lux[at + beside])
        + up * ((1 - right) * lux[above] + right * lux[above + beside]);
  }
}
