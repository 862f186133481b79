package org.maestro.knowledge;

import java.util.LinkedHashSet;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.NamedPoints;
import org.maestro.sl.Point;

/**
 * The points of which somebody speaks, and how many do: a point comes with the first and goes with
 * the last. One writer at a time.
 */
final class SpokenPoints {
  private final Map<String, Integer> speakers = new TreeMap<>();

  /** Those that are new to the home. */
  NamedPoints come(NamedPoints points, Home home) {
    Set<Point> coming = new LinkedHashSet<>();
    for (Point point : points.points()) {
      boolean isKnown = home.individuals().containsKey(point.name());
      if (!isKnown || speakers.containsKey(point.name())) {
        speakers.merge(point.name(), 1, Integer::sum);
      }
      if (!isKnown) {
        coming.add(point);
      }
    }
    return new NamedPoints(coming);
  }

  /** Those of which nobody speaks any more. */
  NamedPoints go(NamedPoints points) {
    Set<Point> going = new LinkedHashSet<>();
    for (Point point : points.points()) {
      Integer left = speakers.computeIfPresent(point.name(), (name, many) -> many - 1);
      if (left != null && left == 0) {
        speakers.remove(point.name());
        going.add(point);
      }
    }
    return new NamedPoints(going);
  }
}
