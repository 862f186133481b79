package org.maestro.device;

import java.util.List;
import org.maestro.ontology.home.Point2;

/**
 * A way over the floor.
 *
 * @param way corners and end, without the start
 * @param length metres
 */
public record Route(List<Point2> way, double length) {
  public Route {
    way = List.copyOf(way);
  }

  Point2 end(Point2 start) {
    return way.isEmpty() ? start : way.get(way.size() - 1);
  }
}
