package org.maestro.ontology.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import java.util.concurrent.atomic.AtomicReferenceArray;
import java.util.stream.IntStream;

/**
 * Shortest ways on the floor: straight where nothing stands between, else by the openings and
 * around corners. Safe for threads.
 */
public final class WayFinder {

  /** How far from a wall's corner one turns around it; metres, half the width of a small robot. */
  private static final double CLEARANCE = 0.3;

  private static final int DIRECTIONS = 8;

  /** From each of them ways lead to many places: who plans asks where a robot could go. */
  private static final int MOST_STARTS = 256;

  private final FloorPlan plan;
  private final List<Point2> turns = new ArrayList<>();
  private final AtomicReferenceArray<int[]> seen;
  private final Map<Point2, WaysFrom> latest = new LinkedHashMap<>();

  /**
   * @param plan of those outlines and openings
   * @param solid outlines around whose corners ways turn
   * @param openings through whose middles ways lead
   */
  public WayFinder(FloorPlan plan, List<Polygon> solid, List<Segment> openings) {
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

  /** Metres; empty when there is no way. */
  public OptionalDouble length(Point2 from, Point2 to) {
    return plan.isBlocked(from, to)
        ? waysFrom(from).length(to)
        : OptionalDouble.of(from.distance(to));
  }

  /** Those from the latest starts are kept. */
  private WaysFrom waysFrom(Point2 start) {
    synchronized (latest) {
      WaysFrom ways = latest.computeIfAbsent(start, WaysFrom::new);
      if (latest.size() > MOST_STARTS) {
        latest.remove(latest.keySet().iterator().next());
      }
      return ways;
    }
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

  /**
   * The shortest ways from one start to the turns around it, known as far as was asked: what leads
   * to one place is the beginning of what leads to others.
   */
  private final class WaysFrom {
    private final double[] lengths = new double[turns.size()];
    private final PriorityQueue<Reached> open =
        new PriorityQueue<>(
            Comparator.comparingDouble(Reached::length).thenComparingInt(Reached::turn));

    /** The turns whose shortest way is known, nearest first. */
    private final List<Reached> done = new ArrayList<>();

    private final Point2 start;
    private boolean begun;

    WaysFrom(Point2 start) {
      this.start = start;
    }

    synchronized OptionalDouble length(Point2 to) {
      begin();
      double shortest = Double.POSITIVE_INFINITY;
      for (Reached turn : done) {
        if (turn.length() >= shortest) {
          break;
        }
        shortest = Math.min(shortest, over(turn, to, shortest));
      }
      while (!open.isEmpty() && open.element().length() < shortest) {
        Reached next = open.remove();
        if (next.length() == lengths[next.turn()]) {
          goOnFrom(next);
          shortest = Math.min(shortest, over(next, to, shortest));
        }
      }
      return Double.isFinite(shortest) ? OptionalDouble.of(shortest) : OptionalDouble.empty();
    }

    private void begin() {
      if (!begun) {
        Arrays.fill(lengths, Double.POSITIVE_INFINITY);
        for (int turn : seenFrom(start)) {
          reach(turn, start.distance(turns.get(turn)));
        }
        begun = true;
      }
    }

    private void reach(int turn, double length) {
      if (length < lengths[turn]) {
        lengths[turn] = length;
        open.add(new Reached(turn, length));
      }
    }

    private double over(Reached turn, Point2 to, double shortest) {
      Point2 point = turns.get(turn.turn());
      double length = turn.length() + point.distance(to);
      return length < shortest && !plan.isBlocked(point, to) ? length : Double.POSITIVE_INFINITY;
    }

    private void goOnFrom(Reached reached) {
      done.add(reached);
      Point2 point = turns.get(reached.turn());
      for (int other : seenFromTurn(reached.turn())) {
        reach(other, reached.length() + point.distance(turns.get(other)));
      }
    }
  }

  /** A turn, and the length of a way to it; metres. */
  private record Reached(int turn, double length) {}
}
