package org.maestro.bench.tracking;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.sl.Term;

/** The ways of a home from the middle of a room to that of another, through doors. Immutable. */
final class FloorWays {
  private static final String ZONE = "Zone";
  private static final String DOOR = "Door";
  private static final String SIDE = "side";

  private final Map<String, Point2> middles = new TreeMap<>();
  private final Map<String, Map<String, Point2>> doors = new TreeMap<>();

  FloorWays(Home home) {
    for (Individual one : home.individuals().values()) {
      if (one.classes().contains(ZONE)) {
        middles.put(one.name(), point(one, "referencePoint"));
      } else if (one.classes().contains(DOOR)) {
        List<String> sides = sides(one);
        Point2 from = point(one, "openingFrom");
        Point2 to = point(one, "openingTo");
        Point2 through = new Point2((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
        add(sides.get(0), sides.get(1), through);
        add(sides.get(1), sides.get(0), through);
      }
    }
  }

  private void add(String from, String to, Point2 through) {
    doors.computeIfAbsent(from, zone -> new TreeMap<>()).put(to, through);
  }

  private static List<String> sides(Individual door) {
    return door.properties().getOrDefault(SIDE, List.of()).stream()
        .map(term -> ((Term.Name) term).text())
        .toList();
  }

  private static Point2 point(Individual one, String property) {
    List<Term> stated = one.properties().getOrDefault(property, List.of());
    double[] numbers = Pose.numbers(((Term.Text) stated.get(0)).value());
    return new Point2(numbers[0], numbers[1]);
  }

  List<String> zones() {
    return List.copyOf(middles.keySet());
  }

  /** How many ways lead from the zone. */
  int doorsOf(String zone) {
    return doors.getOrDefault(zone, Map.of()).size();
  }

  Point2 middle(String zone) {
    return Optional.ofNullable(middles.get(zone)).orElseThrow();
  }

  /**
   * Corners from the middle of one zone to that of another, by the fewest doors; without the first.
   */
  List<Point2> way(String from, String to) {
    Map<String, String> cameFrom = new LinkedHashMap<>(Map.of(from, from));
    Deque<String> open = new ArrayDeque<>(List.of(from));
    while (!open.isEmpty() && !cameFrom.containsKey(to)) {
      String zone = open.remove();
      for (String next : doors.getOrDefault(zone, Map.of()).keySet()) {
        if (cameFrom.putIfAbsent(next, zone) == null) {
          open.add(next);
        }
      }
    }
    List<Point2> corners = new ArrayList<>(List.of(middle(to)));
    for (String zone = to; !zone.equals(from); zone = step(cameFrom, zone)) {
      corners.add(0, door(step(cameFrom, zone), zone));
    }
    return corners;
  }

  private Point2 door(String from, String to) {
    return Optional.ofNullable(doors.getOrDefault(from, Map.of()).get(to)).orElseThrow();
  }

  private static String step(Map<String, String> cameFrom, String zone) {
    return Optional.ofNullable(cameFrom.get(zone)).orElseThrow();
  }
}
