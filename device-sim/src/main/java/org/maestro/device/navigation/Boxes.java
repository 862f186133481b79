package org.maestro.device.navigation;

import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import org.maestro.ontology.floor.Point2;

/**
 * Boxes around things on the floor, kept as plain numbers: most ways lie outside of most boxes,
 * which has to be seen quickly. For the thread that fills it, then for any.
 */
final class Boxes {

  /** By so much boxes are wider than what is asked, so that none leaves out too much; metres. */
  private static final double SLACK = 1e-4;

  private static final int SIDES = 4;

  private final double[] sides;

  Boxes(int count) {
    this.sides = new double[SIDES * count];
  }

  void put(int index, Point2 first, Point2 second, double around) {
    double wide = around + SLACK;
    sides[SIDES * index] = Math.min(first.x(), second.x()) - wide;
    sides[SIDES * index + 1] = Math.max(first.x(), second.x()) + wide;
    sides[SIDES * index + 2] = Math.min(first.y(), second.y()) - wide;
    sides[SIDES * index + 3] = Math.max(first.y(), second.y()) + wide;
  }

  boolean touches(int index, double left, double right, double lower, double upper) {
    int at = SIDES * index;
    return sides[at] <= right
        && sides[at + 1] >= left
        && sides[at + 2] <= upper
        && sides[at + 3] >= lower;
  }

  /** Which of them do. */
  int[] touching(double left, double right, double lower, double upper) {
    return IntStream.range(0, sides.length / SIDES)
        .filter(index -> touches(index, left, right, lower, upper))
        .toArray();
  }

  double left() {
    return side(0).min().orElse(0);
  }

  double right() {
    return side(1).max().orElse(0);
  }

  double lower() {
    return side(2).min().orElse(0);
  }

  double upper() {
    return side(3).max().orElse(0);
  }

  private DoubleStream side(int which) {
    return IntStream.range(0, sides.length / SIDES).mapToDouble(i -> sides[SIDES * i + which]);
  }
}
