package org.maestro.device.navigation;

import java.util.List;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** The free space of a round body among walls and round obstacles. Immutable. */
final class FreeFloor {

  static final double TOLERANCE = 1e-6;
  static final int NONE = -1;

  private final WalledFloor walls;
  private final List<Obstacle> obstacles;
  private final Boxes boxes;

  FreeFloor(WalledFloor walls, List<Obstacle> obstacles) {
    this.walls = walls;
    this.obstacles = List.copyOf(obstacles);
    this.boxes = new Boxes(obstacles.size());
    for (int i = 0; i < obstacles.size(); i++) {
      Obstacle obstacle = obstacles.get(i);
      boxes.put(i, obstacle.middle(), obstacle.middle(), obstacle.radius() + walls.radius());
    }
  }

  /** Whether the body may stand there. */
  boolean isFree(Point2 point) {
    return walls.isFree(point) && firstBarAt(point) == NONE;
  }

  /** An obstacle beside which the body may not stand there, or {@link #NONE}. */
  int firstBarAt(Point2 point) {
    double x = point.x();
    double y = point.y();
    for (int i = 0; i < obstacles.size(); i++) {
      if (boxes.touches(i, x, x, y, y)
          && obstacles.get(i).middle().distance(point)
              < obstacles.get(i).radius() + walls.radius() - TOLERANCE) {
        return i;
      }
    }
    return NONE;
  }

  /** Whether the body can go straight there, given that it stands at the first point. */
  boolean isFreeWay(Point2 from, Point2 to) {
    return isFreeOfWalls(from, to, new Memory()) && firstBar(from, to) == NONE;
  }

  /**
   * The wall that barred the last way: for many ways from one point to places that lie together it
   * is the same wall. For one thread.
   */
  static final class Memory {
    int wall = NONE;
  }

  /** The same for all that walls say, with what barred a way before looked at first. */
  boolean isFreeOfWalls(Point2 from, Point2 to, Memory memory) {
    return walls.isFreeWay(new Segment(from, to), memory);
  }

  /** An obstacle that bars that way, or {@link #NONE}. */
  int firstBar(Point2 from, Point2 to) {
    Segment way = new Segment(from, to);
    double left = Math.min(from.x(), to.x());
    double right = Math.max(from.x(), to.x());
    double lower = Math.min(from.y(), to.y());
    double upper = Math.max(from.y(), to.y());
    for (int i = 0; i < obstacles.size(); i++) {
      if (boxes.touches(i, left, right, lower, upper) && bars(obstacles.get(i), way)) {
        return i;
      }
    }
    return NONE;
  }

  private boolean bars(Obstacle obstacle, Segment way) {
    double needed =
        Math.min(obstacle.radius() + walls.radius(), obstacle.middle().distance(way.from()));
    return way.distance(obstacle.middle()) < needed - TOLERANCE;
  }
}
