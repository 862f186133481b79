package org.maestro.device.navigation;

import java.util.ArrayList;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.function.BooleanSupplier;
import org.maestro.device.navigation.VisibilityGraph.Corner;
import org.maestro.ontology.floor.Point2;

/** A* for the shortest way from the start of a graph to a goal. For one thread, once. */
final class RouteSearch implements VisibilityGraph.Search {

  private static final double TOLERANCE = FreeFloor.TOLERANCE;

  /** A way is mostly found by then; where there is none, a whole house is left to look at. */
  private static final int PASSED_BEFORE_DOUBT = 16;

  private final VisibilityGraph graph;
  private final List<Point2> ends;
  private final BooleanSupplier isCutOff;
  private final PriorityQueue<Entry> open =
      new PriorityQueue<>(
          Comparator.comparingDouble(Entry::estimate).thenComparingInt(entry -> entry.corner.rank));
  private double best = Double.POSITIVE_INFINITY;

  /**
   * @param isCutOff whether it is known that no goal is reached; asked once, of a search that takes
   *     long
   */
  RouteSearch(VisibilityGraph graph, BooleanSupplier isCutOff) {
    this.graph = graph;
    this.ends = graph.goals().stream().map(goal -> goal.at).toList();
    this.isCutOff = isCutOff;
  }

  private record Entry(Corner corner, double length, double estimate) {}

  Optional<Route> shortest() {
    graph.start().length = 0;
    open.add(new Entry(graph.start(), 0, 0));
    int passed = 0;
    while (!open.isEmpty()) {
      Entry next = open.remove();
      Corner corner = next.corner;
      if (next.length > corner.length) {
        continue;
      }
      if (graph.isGoal(corner)) {
        return Optional.of(trace(corner));
      }
      if (passed == PASSED_BEFORE_DOUBT && isCutOff.getAsBoolean()) {
        return Optional.empty();
      }
      graph.pass(corner, this);
      passed++;
    }
    return Optional.empty();
  }

  private Route trace(Corner end) {
    List<Point2> way = new ArrayList<>();
    for (Corner corner = end; corner != graph.start(); corner = corner.before) {
      way.add(corner.at);
    }
    Collections.reverse(way);
    return new Route(way, end.length);
  }

  @Override
  public boolean wants(Corner from, Corner next) {
    double length = length(from, next);
    return length < next.length - TOLERANCE && length < best - TOLERANCE;
  }

  @Override
  public void goesOn(Corner from, Corner next) {
    double length = length(from, next);
    double estimate = length + RoutePlanner.distanceToNearest(next.at, ends);
    if (estimate < best - TOLERANCE) {
      next.length = length;
      next.before = from;
      if (graph.isGoal(next)) {
        best = length;
      }
      open.add(new Entry(next, length, estimate));
    }
  }

  private static double length(Corner from, Corner next) {
    return from.length + from.at.distance(next.at);
  }
}
