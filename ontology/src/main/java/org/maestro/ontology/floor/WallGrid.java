package org.maestro.ontology.floor;

import java.util.ArrayList;
import java.util.List;

/**
 * Walls by the squares of a grid that they touch, so that a way is only compared with those near
 * it. Immutable.
 */
final class WallGrid {
  private static final double LEAST_SIDE_METRES = 0.5;

  /** A wall also counts for squares that it misses by rounding; metres. */
  private static final double MARGIN = 1e-3;

  private static final Segment[] NONE = {};

  private final Rectangle around;
  private final double side;
  private final int columns;
  private final int rows;

  /** Row by row. */
  private final Segment[][] squares;

  WallGrid(List<Segment> walls) {
    this.around =
        Rectangle.around(
            walls.stream().flatMap(wall -> List.of(wall.from(), wall.to()).stream()).toList());
    this.side =
        walls.isEmpty()
            ? LEAST_SIDE_METRES
            : Math.max(
                LEAST_SIDE_METRES,
                Math.max(
                    Math.sqrt(around.width() * around.height() / walls.size()),
                    Math.max(around.width(), around.height()) / walls.size()));
    this.columns = walls.isEmpty() ? 0 : 1 + (int) (around.width() / side);
    this.rows = walls.isEmpty() ? 0 : 1 + (int) (around.height() / side);
    this.squares = squares(walls);
  }

  private Segment[][] squares(List<Segment> walls) {
    List<List<Segment>> lists = new ArrayList<>();
    for (int square = 0; square < columns * rows; square++) {
      lists.add(new ArrayList<>());
    }
    for (Segment wall : walls) {
      Rectangle box = Rectangle.around(List.of(wall.from(), wall.to()));
      for (int row = row(box.bottom() - MARGIN); row <= row(box.top() + MARGIN); row++) {
        for (int column = column(box.left() - MARGIN);
            column <= column(box.right() + MARGIN);
            column++) {
          lists.get(row * columns + column).add(wall);
        }
      }
    }
    return lists.stream().map(list -> list.toArray(NONE)).toArray(Segment[][]::new);
  }

  private int column(double x) {
    return Math.max(0, Math.min(columns - 1, (int) Math.floor((x - around.left()) / side)));
  }

  private int row(double y) {
    return Math.max(0, Math.min(rows - 1, (int) Math.floor((y - around.bottom()) / side)));
  }

  /** Whether the way has a point in common with any wall; looked for from its beginning on. */
  boolean isCrossed(Segment way) {
    if (columns == 0) {
      return false;
    }
    int first = column(way.from().x());
    int last = column(way.to().x());
    int step = first <= last ? 1 : -1;
    for (int column = first; column != last + step; column += step) {
      if (isCrossed(way, column)) {
        return true;
      }
    }
    return false;
  }

  private boolean isCrossed(Segment way, int column) {
    double left = around.left() + column * side - MARGIN;
    double enters = way.yWithin(left, left + side + 2 * MARGIN, true);
    double leaves = way.yWithin(left, left + side + 2 * MARGIN, false);
    int first = row(Math.min(enters, leaves) - MARGIN);
    int last = row(Math.max(enters, leaves) + MARGIN);
    for (int row = first; row <= last; row++) {
      for (Segment wall : squares[row * columns + column]) {
        if (way.mayTouch(wall) && way.intersects(wall)) {
          return true;
        }
      }
    }
    return false;
  }
}
