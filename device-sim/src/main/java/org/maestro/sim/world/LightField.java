package org.maestro.sim.world;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Predicate;
import org.maestro.hal.Area;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.sim.scene.SimulationException;

/**
 * The light of lamps, in the order in which they came, and the rest light of areas. Guarded by the
 * world's lock.
 */
final class LightField {

  private static final int MOST_KEPT = 20_000;

  private final Map<String, LampLight> lamps = new LinkedHashMap<>();
  private final Map<Position, double[]> cubedWays = new HashMap<>();
  private Optional<FloorPlan> planOfWays = Optional.empty();
  private final Map<String, Double> ambient = new TreeMap<>();
  private long version;

  double lux(Position point, Optional<Area> area, FloorPlan plan, Predicate<String> isAlive) {
    double lux = area.map(place -> ambient.getOrDefault(place.name(), 0.0)).orElse(0.0);
    double[] ways = cubedWays(point, plan);
    int next = 0;
    for (Map.Entry<String, LampLight> lamp : lamps.entrySet()) {
      double way = ways[next++];
      if (way > 0 && lamp.getValue().level() > 0 && isAlive.test(lamp.getKey())) {
        lux += lamp.getValue().lux(point, way);
      }
    }
    return lux;
  }

  /** Of all lamps, kept until walls or lamps change: light is asked for at the same points. */
  private double[] cubedWays(Position point, FloorPlan plan) {
    if (planOfWays.isEmpty() || planOfWays.get() != plan || cubedWays.size() > MOST_KEPT) {
      cubedWays.clear();
      planOfWays = Optional.of(plan);
    }
    return cubedWays.computeIfAbsent(
        point,
        place -> lamps.values().stream().mapToDouble(lamp -> lamp.cubedWay(place, plan)).toArray());
  }

  /** What comes from lamps that something hides. */
  double hiddenLux(
      Position point, FloorPlan plan, Predicate<String> isAlive, Predicate<Pose> hidden) {
    double lux = 0;
    for (Map.Entry<String, LampLight> lamp : lamps.entrySet()) {
      double light = isAlive.test(lamp.getKey()) ? lamp.getValue().lux(point, plan) : 0;
      if (light > 0 && hidden.test(lamp.getValue().pose())) {
        lux += light;
      }
    }
    return lux;
  }

  /** Names of lamps that hang over a place for which this holds. */
  List<String> lampsOver(Predicate<Point2> place) {
    return lamps.entrySet().stream()
        .filter(lamp -> place.test(lamp.getValue().pose().floor()))
        .map(Map.Entry::getKey)
        .toList();
  }

  boolean hasLamp(String name) {
    return lamps.containsKey(name);
  }

  /**
   * @throws SimulationException when there is no such lamp
   */
  LampLight lamp(String name) {
    LampLight lamp = lamps.get(name);
    if (lamp == null) {
      throw new SimulationException("There is no lamp " + name + "; there are " + lamps.keySet());
    }
    return lamp;
  }

  void put(String name, LampLight lamp) {
    LampLight former = lamps.put(name, lamp);
    if (former == null || !former.pose().equals(lamp.pose())) {
      cubedWays.clear();
    }
    changed();
  }

  void setAmbient(String area, double lux) {
    ambient.put(area, lux);
    changed();
  }

  /** To be told when power or walls changed. */
  void changed() {
    version++;
  }

  /** Grows with every change of light, so that what was computed from it can be kept meanwhile. */
  long version() {
    return version;
  }
}
