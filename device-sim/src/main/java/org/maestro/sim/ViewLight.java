package org.maestro.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.hal.Area;
import org.maestro.hal.Camera.AreaLight;
import org.maestro.hal.Position;
import org.maestro.ontology.home.FloorPlan;
import org.maestro.ontology.home.Point2;
import org.maestro.ontology.home.Pose;

/** The light in what a camera has in view, kept until light or view change. Clock thread only. */
final class ViewLight {

  /** An area of which so much is in view is covered. */
  private static final double COVERED = 0.95;

  private final World world;
  private final Eye eye;
  private long version = -1;
  private List<Pose> views = List.of();
  private List<Seen> seen = List.of();

  ViewLight(World world, Eye eye) {
    this.world = world;
    this.eye = eye;
  }

  /**
   * An area of which something is in view.
   *
   * @param covered whether nearly all of it is
   */
  private record Seen(AreaLight light, boolean covered) {
    Seen with(double lux) {
      return new Seen(
          new AreaLight(
              light.area(),
              light.referenceLux(),
              Math.min(light.darkestLux(), lux),
              Math.max(light.brightestLux(), lux)),
          covered);
    }
  }

  /** In covered areas. */
  List<AreaLight> covered() {
    return current().stream().filter(Seen::covered).map(Seen::light).toList();
  }

  /** In all areas of which something is in view. */
  List<AreaLight> all() {
    return current().stream().map(Seen::light).toList();
  }

  private List<Seen> current() {
    long now = world.lighting().version();
    List<Pose> from = eye.views().get();
    if (now != version || !from.equals(views)) {
      seen = measured(from);
      version = now;
      views = from;
    }
    return world.lighting().hasDaylight() ? withThings(from) : seen;
  }

  private List<Seen> measured(List<Pose> from) {
    FloorPlan plan = world.building().plan();
    List<Seen> areas = new ArrayList<>();
    for (Area area : world.building().map().areas()) {
      List<Point2> samples = Eye.samples(area);
      double[] lux =
          samples.stream()
              .map(Position::onFloor)
              .filter(point -> eye.sees(point, from, plan))
              .mapToDouble(world::lux)
              .sorted()
              .toArray();
      if (lux.length > 0) {
        boolean covered = lux.length >= COVERED * samples.size();
        double reference = world.lux(Position.onFloor(area.reference()));
        AreaLight light = new AreaLight(area.name(), reference, lux[0], lux[lux.length - 1]);
        Seen inView = new Seen(light, covered);
        areas.add(covered ? inView.with(reference) : inView);
      }
    }
    return List.copyOf(areas);
  }

  /** The sun may shine upon a thing and upon no point at which the floor's light is looked at. */
  private List<Seen> withThings(List<Pose> from) {
    Map<String, Seen> byArea = new TreeMap<>();
    seen.forEach(area -> byArea.put(area.light().area(), area));
    FloorPlan plan = world.building().plan();
    for (Position place : world.whereabouts().placesInTheOpen()) {
      Optional<String> area = world.building().map().areaAt(place.floor()).map(Area::name);
      if (area.isPresent() && byArea.containsKey(area.get()) && eye.sees(place, from, plan)) {
        byArea.computeIfPresent(area.get(), (name, known) -> known.with(world.lux(place)));
      }
    }
    return seen.stream().map(area -> byArea.get(area.light().area())).toList();
  }
}
