package org.maestro.device;

import java.util.List;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.home.Point2;
import org.maestro.ontology.home.Segment;

/**
 * Where a round body has room among walls and round obstacles. Boxes around them are kept as plain
 * numbers: most ways lie outside of most boxes, which has to be seen quickly. Immutable.
 */
final class FreeFloor {

  static final double TOLERANCE = 1e-6;

  /** By so much boxes are wider than what is asked, so that none leaves out too much; metres. */
  private static final double SLACK = 1e-4;

  private static final int SIDES = 4;

  private final List<Segment> walls;
  private final List<Obstacle> obstacles;
  private final double radius;
  private final double[] wallBoxes;
  private final double[] obstacleBoxes;

  /**
   * @param radius of the body; metres
   */
  FreeFloor(List<Segment> walls, List<Obstacle> obstacles, double radius) {
    this.walls = List.copyOf(walls);
    this.obstacles = List.copyOf(obstacles);
    this.radius = radius;
    this.wallBoxes = new double[SIDES * walls.size()];
    this.obstacleBoxes = new double[SIDES * obstacles.size()];
    for (int i = 0; i < walls.size(); i++) {
      put(wallBoxes, i, walls.get(i).from(), walls.get(i).to(), radius + SLACK);
    }
    for (int i = 0; i < obstacles.size(); i++) {
      Obstacle obstacle = obstacles.get(i);
      put(
          obstacleBoxes,
          i,
          obstacle.middle(),
          obstacle.middle(),
          obstacle.radius() + radius + SLACK);
    }
  }

  private static void put(double[] boxes, int index, Point2 first, Point2 second, double around) {
    boxes[SIDES * index] = Math.min(first.x(), second.x()) - around;
    boxes[SIDES * index + 1] = Math.max(first.x(), second.x()) + around;
    boxes[SIDES * index + 2] = Math.min(first.y(), second.y()) - around;
    boxes[SIDES * index + 3] = Math.max(first.y(), second.y()) + around;
  }

  private static boolean touches(
      double[] boxes, int index, double left, double right, double lower, double upper) {
    int at = SIDES * index;
    return boxes[at] <= right
        && boxes[at + 1] >= left
        && boxes[at + 2] <= upper
        && boxes[at + 3] >= lower;
  }

  /** Whether the body may stand there. */
  boolean isFree(Point2 point) {
    double x = point.x();
    double y = point.y();
    for (int i = 0; i < walls.size(); i++) {
      if (touches(wallBoxes, i, x, x, y, y) && walls.get(i).distance(point) < radius - TOLERANCE) {
        return false;
      }
    }
    for (int i = 0; i < obstacles.size(); i++) {
      if (touches(obstacleBoxes, i, x, x, y, y)
          && obstacles.get(i).middle().distance(point)
              < obstacles.get(i).radius() + radius - TOLERANCE) {
        return false;
      }
    }
    return true;
  }

  /** Whether the body can go straight there, given that it stands at the first point. */
  boolean isFreeWay(Point2 from, Point2 to) {
    return isFreeWay(from, to, new Memory());
  }

  /**
   * What barred the last way: for many ways from one point to places that lie together it is the
   * same wall. For one thread.
   */
  static final class Memory {
    private int wall = -1;
  }

  /** The same, with what barred a way before looked at first. */
  boolean isFreeWay(Point2 from, Point2 to, Memory memory) {
    double left = Math.min(from.x(), to.x());
    double right = Math.max(from.x(), to.x());
    double lower = Math.min(from.y(), to.y());
    double upper = Math.max(from.y(), to.y());
    Segment way = new Segment(from, to);
    if (memory.wall >= 0
        && touches(wallBoxes, memory.wall, left, right, lower, upper)
        && bars(walls.get(memory.wall), way)) {
      return false;
    }
    for (int i = 0; i < walls.size(); i++) {
      if (touches(wallBoxes, i, left, right, lower, upper) && bars(walls.get(i), way)) {
        memory.wall = i;
        return false;
      }
    }
    for (int i = 0; i < obstacles.size(); i++) {
      if (touches(obstacleBoxes, i, left, right, lower, upper) && bars(obstacles.get(i), way)) {
        return false;
      }
    }
    return true;
  }

  private boolean bars(Segment wall, Segment way) {
    if (crosses(wall, way)) {
      return true;
    }
    double needed = Math.min(radius, wall.distance(way.from()));
    return distance(wall, way) < needed - TOLERANCE || wall.intersects(way);
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

  private boolean bars(Obstacle obstacle, Segment way) {
    double needed = Math.min(obstacle.radius() + radius, obstacle.middle().distance(way.from()));
    return way.distance(obstacle.middle()) < needed - TOLERANCE;
  }

  private static double distance(Segment first, Segment second) {
    return Math.min(
        Math.min(first.distance(second.from()), first.distance(second.to())),
        Math.min(second.distance(first.from()), second.distance(first.to())));
  }
}
