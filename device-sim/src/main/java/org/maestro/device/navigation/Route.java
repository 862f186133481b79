package org.maestro.device.navigation;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/**
 * A way over the floor.
 *
 * @param way corners and end, without the start
 * @param length metres
 */
public record Route(List<Point2> way, double length) {
  private static final double STEP_METRES = 0.01;

  public Route {
    way = List.copyOf(way);
  }

  public Point2 end(Point2 start) {
    return way.isEmpty() ? start : way.get(way.size() - 1);
  }

  /** Its beginning, as far as to the first place that is wanted, to the centimetre. */
  public Optional<Route> until(Point2 start, Predicate<Point2> wanted) {
    if (wanted.test(start)) {
      return Optional.of(new Route(List.of(), 0));
    }
    List<Point2> passed = new ArrayList<>();
    double driven = 0;
    Point2 corner = start;
    for (Point2 next : way) {
      Segment piece = new Segment(corner, next);
      int steps = (int) Math.ceil(piece.length() / STEP_METRES);
      for (int i = 1; i <= steps; i++) {
        Point2 place = piece.at((double) i / steps);
        if (wanted.test(place)) {
          passed.add(place);
          return Optional.of(new Route(passed, driven + corner.distance(place)));
        }
      }
      passed.add(next);
      driven += piece.length();
      corner = next;
    }
    return Optional.empty();
  }
}
