package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;

/**
 * Shortest ways on the floor: straight where nothing stands between, else by the openings and
 * around corners.
 */
final class WayFinder {

  /** How far from a wall's corner one turns around it; metres, half the width of a small robot. */
  private static final double CLEARANCE = 0.3;

  private static final int DIRECTIONS = 8;

  private final FloorPlan plan;
  private final List<Point2> turns = new ArrayList<>();

  WayFinder(FloorPlan plan, List<Polygon> solid, List<Segment> openings) {
    this.plan = plan;
    for (Segment opening : openings) {
      turns.add(opening.middle());
    }
    for (Polygon outline : solid) {
      for (Point2 corner : outline.corners()) {
        around(corner);
      }
    }
  }

  /** Points beside a corner where one could turn. */
  private void around(Point2 corner) {
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = (2 * i + 1) * Math.PI / DIRECTIONS;
      turns.add(corner.plus(CLEARANCE * Math.cos(angle), CLEARANCE * Math.sin(angle)));
    }
  }

  OptionalDouble length(Point2 from, Point2 to) {
    List<Point2> points = new ArrayList<>(turns);
    points.add(from);
    points.add(to);
    int start = points.size() - 2;
    int end = points.size() - 1;
    double[] lengths = new double[points.size()];
    Arrays.fill(lengths, Double.POSITIVE_INFINITY);
    boolean[] done = new boolean[points.size()];
    lengths[start] = 0;
    for (int next = start; next >= 0 && next != end; next = nearest(lengths, done)) {
      done[next] = true;
      for (int other = 0; other < points.size(); other++) {
        double length = lengths[next] + points.get(next).distance(points.get(other));
        if (!done[other]
            && length < lengths[other]
            && !plan.isBlocked(points.get(next), points.get(other))) {
          lengths[other] = length;
        }
      }
    }
    return Double.isFinite(lengths[end]) ? OptionalDouble.of(lengths[end]) : OptionalDouble.empty();
  }

  /** The point not yet done that is nearest to the start; -1 when none can be reached. */
  private static int nearest(double[] lengths, boolean[] done) {
    int nearest = -1;
    for (int i = 0; i < lengths.length; i++) {
      if (!done[i]
          && Double.isFinite(lengths[i])
          && (nearest < 0 || lengths[i] < lengths[nearest])) {
        nearest = i;
      }
    }
    return nearest;
  }
}
