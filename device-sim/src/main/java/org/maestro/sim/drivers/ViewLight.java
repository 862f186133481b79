package org.maestro.sim.drivers;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.hal.Area;
import org.maestro.hal.Camera.AreaLight;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.sim.world.World;

/** The light in what a camera has in view, kept until light or view change. Clock thread only. */
final class ViewLight {

  /** An area of which so much is in view is covered. */
  private static final double COVERED = 0.95;

  private final World world;
  private final Eye eye;
  private long version = -1;
  private List<Pose> views = List.of();
  private Optional<FloorPlan> plan = Optional.empty();
  private List<Visible> inView = List.of();
  private List<Seen> seen = List.of();

  ViewLight(World world, Eye eye) {
    this.world = world;
    this.eye = eye;
  }

  /**
   * Points in view of an area.
   *
   * @param points at least one
   * @param covered whether they are nearly all of its points
   */
  private record Visible(Area area, List<Position> points, boolean covered) {}

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
  private List<AreaLight> all() {
    return current().stream().map(Seen::light).toList();
  }

  /** Those of all areas in view of which a part in view is brighter than that. */
  List<AreaLight> brighterThan(double lux) {
    return all().stream().filter(area -> area.brightestLux() > lux).toList();
  }

  private List<Seen> current() {
    long now = world.lighting().version();
    List<Pose> from = eye.views().get();
    if (now != version || !from.equals(views)) {
      seen = visible(from).stream().map(this::measured).toList();
      version = now;
    }
    return world.lighting().hasDaylight() ? withThings(from) : seen;
  }

  /** Kept until view, walls or doors change. */
  private List<Visible> visible(List<Pose> from) {
    FloorPlan now = world.building().plan();
    if (plan.filter(before -> before == now).isEmpty() || !from.equals(views)) {
      inView = inView(from, now);
      plan = Optional.of(now);
      views = from;
    }
    return inView;
  }

  private List<Visible> inView(List<Pose> from, FloorPlan now) {
    List<Visible> areas = new ArrayList<>();
    for (Area area : world.building().map().areas()) {
      List<Point2> samples = Eye.samples(area);
      List<Position> points =
          samples.stream()
              .map(Position::onFloor)
              .filter(point -> eye.sees(point, from, now))
              .toList();
      if (!points.isEmpty()) {
        areas.add(new Visible(area, points, points.size() >= COVERED * samples.size()));
      }
    }
    return List.copyOf(areas);
  }

  private Seen measured(Visible visible) {
    double darkest = Double.POSITIVE_INFINITY;
    double brightest = 0;
    for (Position point : visible.points()) {
      double lux = world.lux(point);
      darkest = Math.min(darkest, lux);
      brightest = Math.max(brightest, lux);
    }
    double reference = world.lux(Position.onFloor(visible.area().reference()));
    Seen inView =
        new Seen(
            new AreaLight(visible.area().name(), reference, darkest, brightest), visible.covered());
    return visible.covered() ? inView.with(reference) : inView;
  }

  /** The sun may shine upon a thing and upon no point at which the floor's light is looked at. */
  private List<Seen> withThings(List<Pose> from) {
    Map<String, Seen> byArea = new TreeMap<>();
    seen.forEach(area -> byArea.put(area.light().area(), area));
    for (Position place : world.whereabouts().placesInTheOpen()) {
      Optional<String> area = world.building().map().areaAt(place.floor()).map(Area::name);
      if (area.isPresent()
          && byArea.containsKey(area.get())
          && eye.sees(place, from, world.building().plan())) {
        byArea.computeIfPresent(area.get(), (name, known) -> known.with(world.lux(place)));
      }
    }
    return seen.stream().map(area -> byArea.get(area.light().area())).toList();
  }
}
