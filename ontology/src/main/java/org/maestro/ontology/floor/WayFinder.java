package org.maestro.ontology.floor;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.PriorityQueue;
import java.util.Set;
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
  private final List<Point2> turns;
  private final AtomicReferenceArray<int[]> seen;
  private final Map<Point2, WaysFrom> latest = new LinkedHashMap<>();

  /**
   * @param plan of those outlines and openings
   * @param solid outlines around whose corners ways turn
   * @param openings through whose middles ways lead
   */
  public WayFinder(FloorPlan plan, List<Polygon> solid, List<Segment> openings) {
    this.plan = plan;
    // Outlines that stand side by side have corners in common.
    Set<Point2> each = new LinkedHashSet<>();
    openings.forEach(opening -> each.add(opening.middle()));
    solid.forEach(outline -> outline.corners().forEach(corner -> each.addAll(around(corner))));
    this.turns = List.copyOf(each);
    this.seen = new AtomicReferenceArray<>(turns.size());
  }

  /** Points beside a corner where one could turn. */
  private static List<Point2> around(Point2 corner) {
    List<Point2> around = new ArrayList<>();
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = (2 * i + 1) * Math.PI / DIRECTIONS;
      around.add(corner.plus(CLEARANCE * Math.cos(angle), CLEARANCE * Math.sin(angle)));
    }
    return around;
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
   * The ways from one start to the turns around it, as far as they were followed: what leads to one
   * place is the beginning of what leads to others. They are followed towards the place that is
   * asked for (A* by Hart, Nilsson and Raphael, 1968).
   */
  private final class WaysFrom {
    /** The shortest way to each turn that is known by now; infinite where there is none. */
    private final double[] lengths = new double[turns.size()];

    /** As long as a turn's way was when it was followed on from there. */
    private final double[] followed = new double[turns.size()];

    private final Point2 start;
    private boolean begun;

    WaysFrom(Point2 start) {
      this.start = start;
    }

    synchronized OptionalDouble length(Point2 to) {
      begin();
      PriorityQueue<Reached> towards =
          new PriorityQueue<>(
              Comparator.comparingDouble(Reached::whole).thenComparingInt(Reached::turn));
      for (int turn = 0; turn < lengths.length; turn++) {
        if (Double.isFinite(lengths[turn])) {
          towards.add(reached(turn, to));
        }
      }
      double shortest = Double.POSITIVE_INFINITY;
      while (!towards.isEmpty() && towards.element().whole() < shortest) {
        Reached next = towards.remove();
        if (next.length() > lengths[next.turn()]) {
          continue;
        }
        if (!plan.isBlocked(turns.get(next.turn()), to)) {
          shortest = next.whole();
        } else if (next.length() < followed[next.turn()]) {
          goOnFrom(next, to, towards);
        }
      }
      return Double.isFinite(shortest) ? OptionalDouble.of(shortest) : OptionalDouble.empty();
    }

    private Reached reached(int turn, Point2 to) {
      return new Reached(turn, lengths[turn], lengths[turn] + turns.get(turn).distance(to));
    }

    private void begin() {
      if (!begun) {
        Arrays.fill(lengths, Double.POSITIVE_INFINITY);
        Arrays.fill(followed, Double.POSITIVE_INFINITY);
        for (int turn : seenFrom(start)) {
          lengths[turn] = start.distance(turns.get(turn));
        }
        begun = true;
      }
    }

    private void goOnFrom(Reached reached, Point2 to, PriorityQueue<Reached> towards) {
      followed[reached.turn()] = reached.length();
      Point2 point = turns.get(reached.turn());
      for (int other : seenFromTurn(reached.turn())) {
        double length = reached.length() + point.distance(turns.get(other));
        if (length < lengths[other]) {
          lengths[other] = length;
          towards.add(reached(other, to));
        }
      }
    }
  }

  /**
   * A turn, metres.
   *
   * @param length of a way to it
   * @param whole of the way if it went on straight
   */
  private record Reached(int turn, double length, double whole) {}
}
