package org.maestro.device.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * Shortest ways of a round body among walls and round obstacles: A* over a visibility graph, whose
 * corners lie on 16-sided polygons around wall ends and obstacles. A way is at most 2 % longer than
 * the true one, where it bends. Immutable.
 */
public final class RoutePlanner {

  private static final int SIDES = 16;
  private static final double TOLERANCE = FreeFloor.TOLERANCE;
  private static final double OUTWARD = 1e-4;

  private final WalledFloor walls;
  private final List<Obstacle> obstacles;
  private final FreeFloor floor;

  /**
   * @param radius of the body; metres
   */
  public RoutePlanner(List<Segment> walls, List<Obstacle> obstacles, double radius) {
    this(new WalledFloor(walls, radius), obstacles);
  }

  /** With what is known of the walls for such a body. */
  public RoutePlanner(WalledFloor walls, List<Obstacle> obstacles) {
    this.walls = walls;
    this.obstacles = List.copyOf(obstacles);
    this.floor = new FreeFloor(walls, obstacles);
  }

  /** Whether the body may stand there. */
  public boolean isFree(Point2 point) {
    return floor.isFree(point);
  }

  /**
   * Whether the body can go straight from one point to the other, given that it stands at the
   * first.
   */
  public boolean isFreeWay(Point2 from, Point2 to) {
    return floor.isFreeWay(from, to);
  }

  /**
   * The shortest way to the nearest of the goals that can be reached; those where the body may not
   * stand are left out.
   */
  public Optional<Route> shortest(Point2 start, List<Point2> goals) {
    List<Point2> free = new ArrayList<>();
    for (Point2 goal : goals) {
      if (goal.equals(start)) {
        return Optional.of(new Route(List.of(), 0));
      }
      if (isFree(goal)) {
        free.add(goal);
      }
    }
    if (free.isEmpty()) {
      return Optional.empty();
    }
    return straight(start, free)
        .or(
            () ->
                new RouteSearch(
                        new VisibilityGraph(walls, obstacles, floor, start, free),
                        () -> isCutOff(start, free))
                    .shortest());
  }

  /**
   * Whether it is easily seen that no way leads there: a search for one would go through all of a
   * house.
   */
  boolean isCutOff(Point2 start, List<Point2> goals) {
    if (!isFree(start)) {
      return false;
    }
    Cells cells = walls.cells();
    for (Obstacle body : obstacles) {
      cells.bar(new Segment(body.middle(), body.middle()), body.radius() + walls.radius());
    }
    return !cells.connect(start, goals);
  }

  /** Straight to the nearest goal, if that way is free: then no other is shorter. */
  private Optional<Route> straight(Point2 start, List<Point2> goals) {
    double least = distanceToNearest(start, goals);
    double best = Double.POSITIVE_INFINITY;
    Point2 nearest = start;
    for (Point2 goal : goals) {
      double length = start.distance(goal);
      if (length <= least + TOLERANCE && length < best - TOLERANCE && isFreeWay(start, goal)) {
        best = length;
        nearest = goal;
      }
    }
    return Double.isInfinite(best)
        ? Optional.empty()
        : Optional.of(new Route(List.of(nearest), best));
  }

  static double distanceToNearest(Point2 node, List<Point2> goals) {
    double least = Double.POSITIVE_INFINITY;
    for (Point2 goal : goals) {
      double x = goal.x() - node.x();
      double y = goal.y() - node.y();
      least = Math.min(least, x * x + y * y);
    }
    return Math.sqrt(least);
  }

  /** Corners of a polygon around a circle, a little outside of it. */
  static void addPolygon(List<Point2> points, Point2 middle, double clearance) {
    double outer = clearance / Math.cos(Math.PI / SIDES) + OUTWARD;
    for (int i = 0; i < SIDES; i++) {
      double angle = 2 * Math.PI * i / SIDES;
      points.add(
          new Point2(middle.x() + outer * Math.cos(angle), middle.y() + outer * Math.sin(angle)));
    }
  }
}
