package org.maestro.random;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.Deque;
import java.util.List;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;
import org.maestro.ontology.floor.Segment;

/**
 * The space that one robot can surely reach: cells of 5 cm flooded from where it stands, with 2 cm
 * to spare, the given doors open, other bodies where they are.
 */
final class FreeFloor {
  private static final double CELL = 0.05;
  private static final double SPARE = 0.02;
  private static final double ROBOT_RADIUS = 0.347;
  private static final double REACH = 0.5;
  private static final double HAND_CLEARANCE = 0.11;
  private static final double BESIDE = 0.4;
  private static final int DIRECTIONS = 16;
  private static final double START_METRES = 0.12;

  private record Disc(Point2 middle, double radius) {}

  private final Floor floor;
  private final FloorPlan plan;
  private final List<Segment> walls;
  private final List<Disc> bodies = new ArrayList<>();
  private final BitSet reached = new BitSet();
  private final int columns;
  private final int rows;

  FreeFloor(Site site, Moment moment, String robot, Collection<String> openDoors) {
    this.floor = site.floor();
    this.plan = floor.plan(openDoors);
    this.walls = plan.walls();
    double right = 0;
    double top = 0;
    for (String zone : floor.zones()) {
      for (Point2 corner : floor.outline(zone).corners()) {
        right = Math.max(right, corner.x());
        top = Math.max(top, corner.y());
      }
    }
    this.columns = (int) Math.ceil(right / CELL);
    this.rows = (int) Math.ceil(top / CELL);
    for (String body : moment.places().keySet()) {
      if (!body.equals(robot) && moment.holder(body).isEmpty() && !moment.isHidden(body)) {
        bodies.add(new Disc(moment.place(body).floor(), site.radius(body)));
      }
    }
    flood(moment.place(robot).floor());
  }

  private void flood(Point2 start) {
    Deque<Integer> queue = new ArrayDeque<>();
    for (int cell = 0; cell < columns * rows; cell++) {
      if (middle(cell).distance(start) <= START_METRES
          && isFree(middle(cell), ROBOT_RADIUS + SPARE)) {
        reached.set(cell);
        queue.add(cell);
      }
    }
    BitSet refused = new BitSet();
    while (!queue.isEmpty()) {
      int cell = queue.remove();
      int column = cell % columns;
      int[] next = {
        column > 0 ? cell - 1 : -1,
        column < columns - 1 ? cell + 1 : -1,
        cell - columns,
        cell + columns
      };
      for (int other : next) {
        if (other < 0 || other >= columns * rows || reached.get(other) || refused.get(other)) {
          continue;
        }
        if (isFree(middle(other), ROBOT_RADIUS + SPARE)) {
          reached.set(other);
          queue.add(other);
        } else {
          refused.set(other);
        }
      }
    }
  }

  private Point2 middle(int cell) {
    int column = cell % columns;
    int row = cell / columns;
    return new Point2((column + 0.5) * CELL, (row + 0.5) * CELL);
  }

  private boolean isFree(Point2 point, double radius) {
    return walls.stream().allMatch(wall -> wall.distance(point) >= radius)
        && bodies.stream().allMatch(b -> b.middle().distance(point) >= b.radius() + radius);
  }

  private boolean isReached(Point2 point) {
    int column = (int) (point.x() / CELL);
    int row = (int) (point.y() / CELL);
    return column >= 0
        && column < columns
        && row >= 0
        && row < rows
        && reached.get(row * columns + column)
        && isFree(point, ROBOT_RADIUS + SPARE);
  }

  /** Whether the robot can stand wholly in the zone; in nothing else it can. */
  boolean reaches(String zone) {
    if (!floor.isZone(zone)) {
      return false;
    }
    Polygon outline = floor.outline(zone);
    return reached.stream()
        .mapToObj(this::middle)
        .anyMatch(
            point ->
                outline.contains(point)
                    && outline.edges().stream()
                        .allMatch(edge -> edge.distance(point) >= ROBOT_RADIUS + SPARE));
  }

  /** Whether its hand reaches what lies there. */
  boolean reaches(Position place) {
    return reachesOver(place.floor());
  }

  /** Whether it can put something down beside what stands there. */
  boolean reachesBeside(Position place, double radius) {
    double distance = Math.max(BESIDE, radius + HAND_CLEARANCE);
    return around(place.floor(), distance).stream()
        .filter(spot -> floor.zoneAt(spot).isPresent() && isFree(spot, HAND_CLEARANCE))
        .anyMatch(this::reachesOver);
  }

  /** No hand goes through a wall. */
  private boolean reachesOver(Point2 spot) {
    return around(spot, REACH).stream()
        .anyMatch(point -> isReached(point) && !plan.isBlocked(point, spot));
  }

  private static List<Point2> around(Point2 middle, double distance) {
    List<Point2> points = new ArrayList<>();
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = 2 * Math.PI * i / DIRECTIONS;
      points.add(
          new Point2(
              middle.x() + distance * Math.cos(angle), middle.y() + distance * Math.sin(angle)));
    }
    return points;
  }
}
