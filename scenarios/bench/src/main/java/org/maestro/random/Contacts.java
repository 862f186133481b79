package org.maestro.random;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import org.maestro.sim.world.World;

/** Robots and persons that run into each other: who overlap, and come nearer by moving. */
final class Contacts {
  /** What rounding makes of two bodies that pass at their very radii. */
  private static final double GRAZING_METRES = 0.02;

  private final World world;
  private final Site site;
  private final Map<String, Double> before = new HashMap<>();
  private final List<String> found = new ArrayList<>();

  Contacts(World world, Site site) {
    this.world = world;
    this.site = site;
  }

  /** Somebody was put elsewhere: where she is now is nobody's fault. */
  void forget() {
    before.clear();
  }

  /** To be told of the passing of time, as often as anything happens. */
  void timePassed() {
    for (String robot : site.robots()) {
      for (String person : site.persons()) {
        look(robot, person);
      }
    }
  }

  private void look(String robot, String person) {
    double distance = world.distance(robot, person);
    Double last = before.put(robot + " " + person, distance);
    double apart = world.radius(robot) + world.radius(person) - GRAZING_METRES;
    if (distance < apart && last != null && distance < last) {
      found.add(
          String.format(
              Locale.ROOT,
              "%s and %s at %.3f s, %.3f m apart",
              robot,
              person,
              world.now().toNanos() / 1e9,
              distance));
    }
  }

  List<String> found() {
    return List.copyOf(found);
  }
}
