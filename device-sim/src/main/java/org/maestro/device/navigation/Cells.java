package org.maestro.device.navigation;

import java.util.BitSet;
import java.util.List;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * The floor in small squares, of which some are barred: nowhere in them can the body stand. Where
 * no chain of others leads from one place to another, no way does; where one does, there may be a
 * way. For the thread that bars, then for any.
 */
final class Cells {

  private static final double LEAST_SIDE_METRES = 0.1;

  /** Along each side: on a wide floor squares are larger, and fewer of them can be barred. */
  private static final double MOST_SQUARES = 1_000;

  private final double side;
  private final double left;
  private final double lower;
  private final int columns;
  private final int rows;
  private final BitSet barred;

  /** All around which anything is to be barred, with one square more on each side. */
  Cells(double left, double right, double lower, double upper) {
    this.side = Math.max(LEAST_SIDE_METRES, Math.max(right - left, upper - lower) / MOST_SQUARES);
    this.left = left - side;
    this.lower = lower - side;
    this.columns = (int) Math.ceil((right - this.left) / side) + 1;
    this.rows = (int) Math.ceil((upper - this.lower) / side) + 1;
    this.barred = new BitSet(columns * rows);
  }

  private Cells(Cells other) {
    this.side = other.side;
    this.left = other.left;
    this.lower = other.lower;
    this.columns = other.columns;
    this.rows = other.rows;
    this.barred = (BitSet) other.barred.clone();
  }

  Cells copy() {
    return new Cells(this);
  }

  /** Bars the squares that lie wholly nearer to it than that, as far as that is easily seen. */
  void bar(Segment line, double metres) {
    double sure = metres - side * Math.sqrt(0.5);
    int lastColumn = column(Math.max(line.from().x(), line.to().x()) + sure);
    int lastRow = row(Math.max(line.from().y(), line.to().y()) + sure);
    for (int row = row(Math.min(line.from().y(), line.to().y()) - sure); row <= lastRow; row++) {
      for (int column = column(Math.min(line.from().x(), line.to().x()) - sure);
          column <= lastColumn;
          column++) {
        if (isInside(column, row) && line.distance(middle(column, row)) < sure) {
          barred.set(row * columns + column);
        }
      }
    }
  }

  /** Whether a chain of squares leads from there to one of the others. */
  boolean connect(Point2 from, List<Point2> to) {
    BitSet wanted = new BitSet(columns * rows);
    to.forEach(place -> wanted.set(cell(place)));
    BitSet closed = (BitSet) barred.clone();
    int[] open = new int[columns * rows];
    int count = 0;
    open[count++] = cell(from);
    closed.set(open[0]);
    while (count > 0) {
      int cell = open[--count];
      if (wanted.get(cell)) {
        return true;
      }
      int column = cell % columns;
      if (column > 0 && !closed.get(cell - 1)) {
        closed.set(cell - 1);
        open[count++] = cell - 1;
      }
      if (column < columns - 1 && !closed.get(cell + 1)) {
        closed.set(cell + 1);
        open[count++] = cell + 1;
      }
      if (cell >= columns && !closed.get(cell - columns)) {
        closed.set(cell - columns);
        open[count++] = cell - columns;
      }
      if (cell < columns * (rows - 1) && !closed.get(cell + columns)) {
        closed.set(cell + columns);
        open[count++] = cell + columns;
      }
    }
    return false;
  }

  /** The outermost ones stand for all that lies beyond, where nothing is barred. */
  private boolean isInside(int column, int row) {
    return column > 0 && column < columns - 1 && row > 0 && row < rows - 1;
  }

  private int cell(Point2 place) {
    return row(place.y()) * columns + column(place.x());
  }

  private int column(double x) {
    return within(x - left, columns);
  }

  private int row(double y) {
    return within(y - lower, rows);
  }

  private int within(double metres, int count) {
    return Math.max(0, Math.min(count - 1, (int) Math.floor(metres / side)));
  }

  private Point2 middle(int column, int row) {
    return new Point2(left + (column + 0.5) * side, lower + (row + 0.5) * side);
  }
}
