package org.maestro.random;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;

/**
 * The light that can be made with the lamps and the shutter that can be used, all others staying as
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
    List<Demand> demands = new ArrayList<>();
    constraints.forEach(constraint -> demands.add(demand(lamps, constraint)));
    for (Position place : seen) {
      demands.add(demand(lamps, place, Site.CAMERA_LEAST_LUX * (1 + Truths.CLOSE_LIGHT), true));
      demands.add(demand(lamps, place, Site.CAMERA_GREATEST_LUX * (1 - Truths.CLOSE_LIGHT), false));
    }
    return search(lamps.size(), 0, demands);
  }

  /**
   * A sum over lamps that has to be at least a limit, or at most; all of it negated when at most.
   *
   * @param shares by lamp and level
   * @param best what the lamps from each one on can add at most
   */
  private record Demand(double[][] shares, double[] best, double missing) {
    static Demand of(double[][] shares, double missing) {
      double[] best = new double[shares.length + 1];
      for (int lamp = shares.length - 1; lamp >= 0; lamp--) {
        best[lamp] = best[lamp + 1] + Arrays.stream(shares[lamp]).max().orElseThrow();
      }
      return new Demand(shares, best, missing);
    }

    Demand with(int lamp, int level) {
      return new Demand(shares, best, missing - shares[lamp][level]);
    }

    boolean canBeMet(int nextLamp) {
      return best[nextLamp] >= missing - SAME_LUX;
    }
  }

  private Demand demand(List<String> lamps, Truths.Constraint constraint) {
    double sign = constraint.atLeast() ? 1 : -1;
    if (constraint.isOfLight()) {
      double margin = sign * Truths.CLOSE_LIGHT * constraint.number();
      return demand(
          lamps,
          site.floor().location(constraint.subject()),
          constraint.number() + margin,
          constraint.atLeast());
    }
    double[][] shares = new double[lamps.size()][LEVELS.size()];
    boolean settable = lamps.contains(constraint.subject());
    for (int level = 0; level < LEVELS.size() && settable; level++) {
      shares[lamps.indexOf(constraint.subject())][level] = sign * LEVELS.get(level);
    }
    double fixed = settable ? 0 : moment.levels().get(constraint.subject());
    return Demand.of(shares, sign * (constraint.number() - fixed));
  }

  private Demand demand(List<String> lamps, Position place, double limit, boolean atLeast) {
    double sign = atLeast ? 1 : -1;
    Map<String, Double> others = new TreeMap<>(moment.levels());
    others.keySet().removeAll(lamps);
    String zone = site.floor().zoneAt(place.floor()).orElse("");
    double[][] shares = new double[lamps.size()][LEVELS.size()];
    for (int lamp = 0; lamp < lamps.size(); lamp++) {
      String name = lamps.get(lamp);
      double share = share(name, place);
      for (int level = 0; level < LEVELS.size(); level++) {
        shares[lamp][level] = sign * share * counted(name, LEVELS.get(level), place, atLeast);
      }
    }
    return Demand.of(shares, sign * (limit - lux(place, zone, others)));
  }

  private static boolean search(int lamps, int next, List<Demand> demands) {
    if (!demands.stream().allMatch(demand -> demand.canBeMet(next))) {
      return false;
    }
    if (next == lamps) {
      return true;
    }
    for (int level = 0; level < LEVELS.size(); level++) {
      int chosen = level;
      List<Demand> left = demands.stream().map(demand -> demand.with(next, chosen)).toList();
      if (search(lamps, next + 1, left)) {
        return true;
      }
    }
    return false;
  }

  private boolean matters(String lamp, Truths.Constraint constraint) {
    return constraint.isOfLight()
        ? share(lamp, site.floor().location(constraint.subject())) > LEAST_SHARE_LUX
        : lamp.equals(constraint.subject());
  }

  private double lux(String location, Map<String, Double> levels) {
    return lux(site.floor().location(location), site.floor().zoneOf(location), levels);
  }

  /**
   * The level that can be counted on there. Of light that comes through an open door nobody knows
   * what it will do: it stays as it is, or changes for the worse.
   */
  private double counted(String lamp, double level, Position place, boolean forLight) {
    if (isInRoom(lamp, place)) {
      return level;
    }
    double now = moment.level(lamp);
    return forLight ? Math.min(level, now) : Math.max(level, now);
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
