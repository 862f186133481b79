package org.maestro.ontology.home;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalDouble;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.IntStream;

/**
 * Shortest ways on the floor: straight where nothing stands between, else by the openings and
 * around corners. Safe for threads.
 */
final class WayFinder {

  /** How far from a wall's corner one turns around it; metres, half the width of a small robot. */
  private static final double CLEARANCE = 0.3;

  private static final int DIRECTIONS = 8;

  private final FloorPlan plan;
  private final List<Point2> turns = new ArrayList<>();
  private final AtomicReferenceArray<int[]> seen;

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
    this.seen = new AtomicReferenceArray<>(turns.size());
  }

  /** Points beside a corner where one could turn. */
  private void around(Point2 corner) {
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = (2 * i + 1) * Math.PI / DIRECTIONS;
      turns.add(corner.plus(CLEARANCE * Math.cos(angle), CLEARANCE * Math.sin(angle)));
    }
  }

  OptionalDouble length(Point2 from, Point2 to) {
    int start = turns.size();
    int end = start + 1;
    double[] lengths = new double[end + 1];
    Arrays.fill(lengths, Double.POSITIVE_INFINITY);
    boolean[] done = new boolean[lengths.length];
    lengths[start] = 0;
    for (int next = start; next >= 0 && next != end; next = nearest(lengths, done)) {
      done[next] = true;
      Point2 here = next == start ? from : turns.get(next);
      for (int other : next == start ? seenFrom(from) : seenFromTurn(next)) {
        lengths[other] = Math.min(lengths[other], lengths[next] + here.distance(turns.get(other)));
      }
      double last = lengths[next] + here.distance(to);
      if (last < lengths[end] && !plan.isBlocked(here, to)) {
        lengths[end] = last;
      }
    }
    return Double.isFinite(lengths[end]) ? OptionalDouble.of(lengths[end]) : OptionalDouble.empty();
  }

  /** Walls do not move, so that it is found out once for each turn that a way leads over. */
  private int[] seenFromTurn(int turn) {
    int[] known = seen.get(turn);
    if (known == null) {
      known = seenFrom(turns.get(turn));
      seen.set(turn, known);
    }
    return known;
  }

  /** The turns to which one can go straight. */
  private int[] seenFrom(Point2 point) {
    return IntStream.range(0, turns.size())
        .filter(turn -> !plan.isBlocked(point, turns.get(turn)))
        .toArray();
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
