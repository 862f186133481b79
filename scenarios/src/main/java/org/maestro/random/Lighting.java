package org.maestro.random;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.ontology.home.FloorPlan;
import org.maestro.ontology.home.Point2;
import org.maestro.ontology.home.Pose;

/**
 * What light can be made with the lamps and the shutter that can be used, all others staying as
 * they are: every combination of levels is tried.
 */
final class Lighting {
  private static final List<Double> LEVELS = List.of(0.0, 0.25, 0.5, 1.0);
  private static final double LEAST_SHARE_LUX = 0.5;
  private static final double SAME_LUX = 1e-6;

  private final Site site;
  private final Moment moment;
  private final FloorPlan plan;
  private final FloorPlan shut;
  private final Collection<String> usableLamps;

  Lighting(Site site, Moment moment, Collection<String> usableLamps) {
    this.site = site;
    this.moment = moment;
    this.plan = site.floor().plan(moment.openDoors());
    this.shut = site.floor().plan(List.of());
    this.usableLamps = usableLamps;
    check();
  }

  /** The judge's own light has to be that of the world, or he judges nothing. */
  private void check() {
    for (String location : site.floor().locations().keySet()) {
      double own = lux(location, moment.levels());
      if (Math.abs(own - moment.light(location)) > SAME_LUX) {
        throw new IllegalStateException(
            "The judge computes %s lux at %s, and the world %s"
                .formatted(own, location, moment.light(location)));
      }
    }
  }

  /** Whether some levels of the lamps meet all of these at the same time. */
  boolean canMeet(List<Truths.Constraint> constraints) {
    return search(constraints, List.of());
  }

  /** Whether they can, and a camera sees what is at each of these places. */
  boolean canMeet(List<Truths.Constraint> constraints, List<Position> seen) {
    return search(constraints, seen);
  }

  private boolean search(List<Truths.Constraint> constraints, List<Position> seen) {
    List<String> lamps = new ArrayList<>();
    for (String lamp : usableLamps) {
      boolean matters =
          constraints.stream().anyMatch(constraint -> matters(lamp, constraint))
              || seen.stream().anyMatch(place -> share(lamp, place) > LEAST_SHARE_LUX);
      if (matters) {
        lamps.add(lamp);
      }
    }
    return search(lamps, 0, new TreeMap<>(moment.levels()), constraints, seen);
  }

  private boolean matters(String lamp, Truths.Constraint constraint) {
    return constraint.isOfLight()
        ? share(lamp, site.floor().location(constraint.subject())) > LEAST_SHARE_LUX
        : lamp.equals(constraint.subject());
  }

  private boolean search(
      List<String> lamps,
      int next,
      Map<String, Double> levels,
      List<Truths.Constraint> constraints,
      List<Position> seen) {
    if (next == lamps.size()) {
      return constraints.stream()
              .allMatch(
                  c -> c.isMet(location -> lux(location, counted(levels, location, c)), levels))
          && seen.stream().allMatch(place -> isVisible(place, levels));
    }
    for (double level : LEVELS) {
      levels.put(lamps.get(next), level);
      if (search(lamps, next + 1, levels, constraints, seen)) {
        return true;
      }
    }
    return false;
  }

  private boolean isVisible(Position place, Map<String, Double> levels) {
    String zone = site.floor().zoneAt(place.floor()).orElse("");
    return lux(place, zone, counted(levels, place, true))
            >= Site.CAMERA_LEAST_LUX * (1 + Truths.CLOSE_LIGHT)
        && lux(place, zone, counted(levels, place, false))
            <= Site.CAMERA_GREATEST_LUX * (1 - Truths.CLOSE_LIGHT);
  }

  private double lux(String location, Map<String, Double> levels) {
    return lux(site.floor().location(location), site.floor().zoneOf(location), levels);
  }

  private Map<String, Double> counted(
      Map<String, Double> levels, String location, Truths.Constraint constraint) {
    return counted(levels, site.floor().location(location), constraint.atLeast());
  }

  /**
   * The levels that can be counted on there. Of light that comes through an open door nobody knows
   * what it will do: it stays as it is, or changes for the worse.
   */
  private Map<String, Double> counted(
      Map<String, Double> levels, Position place, boolean forLight) {
    Map<String, Double> counted = new TreeMap<>(levels);
    counted.replaceAll(
        (lamp, level) -> {
          if (isInRoom(lamp, place)) {
            return level;
          }
          double now = moment.levels().get(lamp);
          return forLight ? Math.min(level, now) : Math.max(level, now);
        });
    return counted;
  }

  private boolean isInRoom(String lamp, Position place) {
    Point2 from =
        site.shutters().contains(lamp) ? site.insideOfWindow(lamp) : site.pose(lamp).floor();
    return !shut.isBlocked(from, place.floor());
  }

  private double lux(Position point, String zone, Map<String, Double> levels) {
    double lux = zone.isEmpty() ? 0 : site.ambient(zone);
    for (Map.Entry<String, Double> lamp : levels.entrySet()) {
      boolean shines = moment.isAlive(lamp.getKey()) || site.shutters().contains(lamp.getKey());
      if (lamp.getValue() > 0 && shines) {
        lux += lamp.getValue() * share(lamp.getKey(), point);
      }
    }
    return lux;
  }

  /** What the lamp adds there at full level, or the shutter when it is open. */
  private double share(String lamp, Position point) {
    if (site.shutters().contains(lamp)) {
      return moment.daylight(point);
    }
    Pose pose = site.pose(lamp);
    double height = pose.z() - point.z();
    if (pose.angleTo(point.x(), point.y(), point.z()) > site.number(lamp, "beamAngle") / 2
        || plan.isBlocked(pose.floor(), point.floor())) {
      return 0;
    }
    double far = Math.hypot(height, pose.floor().distance(point.floor()));
    return site.strength(lamp)
        * site.number(lamp, "luminousIntensity")
        * height
        / (far * far * far);
  }
}
