package org.maestro.device.navigation;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
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
    List<Point2> nodes = new ArrayList<>();
    nodes.add(start);
    for (Point2 goal : goals) {
      if (goal.equals(start)) {
        return Optional.of(new Route(List.of(), 0));
      }
      if (isFree(goal)) {
        nodes.add(goal);
      }
    }
    int firstCorner = nodes.size();
    if (firstCorner == 1) {
      return Optional.empty();
    }
    List<Point2> free = List.copyOf(nodes.subList(1, firstCorner));
    Optional<Route> straight = straight(start, free);
    if (straight.isPresent()) {
      return straight;
    }
    nodes.addAll(corners());
    double[] rest = new double[nodes.size()];
    for (int i = 0; i < rest.length; i++) {
      boolean goal = i > 0 && i < firstCorner;
      rest[i] = goal ? 0 : distanceToNearest(nodes.get(i), free);
    }
    return search(nodes, firstCorner, rest);
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

  private static double distanceToNearest(Point2 node, List<Point2> goals) {
    double least = Double.POSITIVE_INFINITY;
    for (Point2 goal : goals) {
      double x = goal.x() - node.x();
      double y = goal.y() - node.y();
      least = Math.min(least, x * x + y * y);
    }
    return Math.sqrt(least);
  }

  private List<Point2> corners() {
    List<Point2> around = new ArrayList<>();
    for (Point2 corner : walls.corners()) {
      if (floor.isFreeOfObstacles(corner)) {
        around.add(corner);
      }
    }
    List<Point2> atObstacles = new ArrayList<>();
    obstacles.forEach(
        obstacle -> addPolygon(atObstacles, obstacle.middle(), obstacle.radius() + walls.radius()));
    atObstacles.removeIf(corner -> !isFree(corner));
    around.addAll(atObstacles);
    return around;
  }

  private Optional<Route> search(List<Point2> nodes, int firstCorner, double[] rest) {
    int count = nodes.size();
    double[] length = new double[count];
    Arrays.fill(length, Double.POSITIVE_INFINITY);
    int[] before = new int[count];
    boolean[] closed = new boolean[count];
    PriorityQueue<Entry> open =
        new PriorityQueue<>(
            Comparator.comparingDouble(Entry::estimate).thenComparingInt(Entry::node));
    double best = Double.POSITIVE_INFINITY;
    FreeFloor.Memory memory = new FreeFloor.Memory();
    length[0] = 0;
    open.add(new Entry(0, rest[0]));
    while (!open.isEmpty()) {
      int node = open.remove().node();
      if (closed[node]) {
        continue;
      }
      closed[node] = true;
      if (node > 0 && node < firstCorner) {
        return Optional.of(trace(nodes, before, node, length[node]));
      }
      for (int next = 1; next < count; next++) {
        double reached = length[node] + nodes.get(node).distance(nodes.get(next));
        if (!closed[next]
            && reached < length[next] - TOLERANCE
            && reached + rest[next] < best - TOLERANCE
            && floor.isFreeWay(nodes.get(node), nodes.get(next), memory)) {
          length[next] = reached;
          before[next] = node;
          if (next < firstCorner) {
            best = reached;
          }
          open.add(new Entry(next, reached + rest[next]));
        }
      }
    }
    return Optional.empty();
  }

  private static Route trace(List<Point2> nodes, int[] before, int end, double length) {
    List<Point2> way = new ArrayList<>();
    for (int node = end; node != 0; node = before[node]) {
      way.add(nodes.get(node));
    }
    Collections.reverse(way);
    return new Route(way, length);
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

  private record Entry(int node, double estimate) {}
}
