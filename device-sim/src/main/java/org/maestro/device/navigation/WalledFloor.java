package org.maestro.device.navigation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * The free space that walls leave to a round body. Walls stay the same until a door moves, so that
 * what is known of them can be kept meanwhile. Squares of the floor know the walls near them: a way
 * has to be held against those alone that stand along it, and corners know each other once a way
 * passed them. Thread-safe.
 */
public final class WalledFloor {

  /** Of a square; metres. */
  private static final double SQUARE_METRES = 0.5;

  private static final int[] NOTHING = {};

  private final List<Segment> walls;
  private final double radius;
  private final Boxes boxes;
  private final double left;
  private final double lower;
  private final int columns;
  private final int rows;
  private final int[][] near;
  private final List<Point2> corners;
  private final AtomicReferenceArray<int[]> seenFrom;
  private final AtomicReference<@Nullable Cells> cells = new AtomicReference<>();

  /**
   * @param radius of the body; metres
   */
  public WalledFloor(List<Segment> walls, double radius) {
    this.walls = List.copyOf(walls);
    this.radius = radius;
    this.boxes = new Boxes(walls.size());
    for (int i = 0; i < this.walls.size(); i++) {
      boxes.put(i, this.walls.get(i).from(), this.walls.get(i).to(), radius);
    }
    this.left = boxes.left();
    this.lower = boxes.lower();
    this.columns = walls.isEmpty() ? 0 : square(boxes.right() - left) + 1;
    this.rows = walls.isEmpty() ? 0 : square(boxes.upper() - lower) + 1;
    this.near = nearEachSquare();
    this.corners = freeCorners();
    this.seenFrom = new AtomicReferenceArray<>(corners.size());
  }

  private int[][] nearEachSquare() {
    int[][] found = new int[columns * rows][];
    for (int row = 0; row < rows; row++) {
      for (int column = 0; column < columns; column++) {
        double fromX = left + column * SQUARE_METRES;
        double fromY = lower + row * SQUARE_METRES;
        found[row * columns + column] =
            boxes.touching(fromX, fromX + SQUARE_METRES, fromY, fromY + SQUARE_METRES);
      }
    }
    return found;
  }

  private List<Point2> freeCorners() {
    Set<Point2> ends = new LinkedHashSet<>();
    walls.forEach(wall -> Collections.addAll(ends, wall.from(), wall.to()));
    List<Point2> around = new ArrayList<>();
    ends.forEach(end -> RoutePlanner.addPolygon(around, end, radius));
    around.removeIf(corner -> !isFree(corner));
    return List.copyOf(around);
  }

  /** The same if it is still true, a new one otherwise. */
  public WalledFloor with(List<Segment> others) {
    return walls.equals(others) ? this : new WalledFloor(others, radius);
  }

  double radius() {
    return radius;
  }

  /** Around ends of walls, where a way may bend; those at which the body may not stand are out. */
  List<Point2> corners() {
    return corners;
  }

  /** Which corners can be reached straight from one of them, for all that walls say. */
  int[] seenFrom(int corner) {
    int[] known = seenFrom.get(corner);
    if (known == null) {
      FreeFloor.Memory memory = new FreeFloor.Memory();
      Point2 from = corners.get(corner);
      known =
          IntStream.range(0, corners.size())
              .filter(to -> to != corner && isFreeWay(new Segment(from, corners.get(to)), memory))
              .toArray();
      seenFrom.set(corner, known);
    }
    return known;
  }

  /** Squares where walls let it stand nowhere; a copy. */
  Cells cells() {
    Cells known = cells.get();
    if (known == null) {
      known = new Cells(boxes.left(), boxes.right(), boxes.lower(), boxes.upper());
      for (Segment wall : walls) {
        known.bar(wall, radius);
      }
      cells.set(known);
    }
    return known.copy();
  }

  /** Whether the body may stand there, for all that walls say. */
  boolean isFree(Point2 point) {
    double x = point.x();
    double y = point.y();
    for (int wall : near(square(x - left), square(y - lower))) {
      if (boxes.touches(wall, x, x, y, y)
          && walls.get(wall).distance(point) < radius - FreeFloor.TOLERANCE) {
        return false;
      }
    }
    return true;
  }

  /** Whether walls let the body go straight there, given that it stands at the first point. */
  boolean isFreeWay(Segment way, FreeFloor.Memory memory) {
    if (memory.wall >= 0 && bars(memory.wall, way)) {
      return false;
    }
    double fromX = (way.from().x() - left) / SQUARE_METRES;
    double fromY = (way.from().y() - lower) / SQUARE_METRES;
    double overX = (way.to().x() - left) / SQUARE_METRES - fromX;
    double overY = (way.to().y() - lower) / SQUARE_METRES - fromY;
    int column = (int) Math.floor(fromX);
    int row = (int) Math.floor(fromY);
    int lastColumn = (int) Math.floor(fromX + overX);
    int lastRow = (int) Math.floor(fromY + overY);
    double toNextColumn = shareToNext(fromX, overX);
    double toNextRow = shareToNext(fromY, overY);
    int steps = Math.abs(lastColumn - column) + Math.abs(lastRow - row);
    for (int step = 0; step <= steps; step++) {
      for (int wall : near(column, row)) {
        if (bars(wall, way)) {
          memory.wall = wall;
          return false;
        }
      }
      boolean across = row == lastRow || column != lastColumn && toNextColumn < toNextRow;
      if (across) {
        column += overX > 0 ? 1 : -1;
        toNextColumn += 1 / Math.abs(overX);
      } else {
        row += overY > 0 ? 1 : -1;
        toNextRow += 1 / Math.abs(overY);
      }
    }
    return true;
  }

  /** The share of a way after which it enters the next square along an axis. */
  private static double shareToNext(double from, double over) {
    if (over == 0) {
      return Double.POSITIVE_INFINITY;
    }
    double inSquare = from - Math.floor(from);
    return (over > 0 ? 1 - inSquare : inSquare) / Math.abs(over);
  }

  private int[] near(int column, int row) {
    return column < 0 || column >= columns || row < 0 || row >= rows
        ? NOTHING
        : near[row * columns + column];
  }

  private static int square(double metres) {
    return (int) Math.floor(metres / SQUARE_METRES);
  }

  private boolean bars(int index, Segment way) {
    Point2 from = way.from();
    Point2 to = way.to();
    if (!boxes.touches(
        index,
        Math.min(from.x(), to.x()),
        Math.max(from.x(), to.x()),
        Math.min(from.y(), to.y()),
        Math.max(from.y(), to.y()))) {
      return false;
    }
    Segment wall = walls.get(index);
    if (crosses(wall, way)) {
      return true;
    }
    double needed = Math.min(radius, wall.distance(from));
    return distance(wall, way) < needed - FreeFloor.TOLERANCE || wall.intersects(way);
  }

  /** Surely; what only touches is left to others. */
  private static boolean crosses(Segment wall, Segment way) {
    return side(wall, way.from()) * side(wall, way.to()) < 0
        && side(way, wall.from()) * side(way, wall.to()) < 0;
  }

  private static double side(Segment line, Point2 point) {
    return (line.to().x() - line.from().x()) * (point.y() - line.from().y())
        - (line.to().y() - line.from().y()) * (point.x() - line.from().x());
  }

  private static double distance(Segment first, Segment second) {
    return Math.min(
        Math.min(first.distance(second.from()), first.distance(second.to())),
        Math.min(second.distance(first.from()), second.distance(first.to())));
  }
}
