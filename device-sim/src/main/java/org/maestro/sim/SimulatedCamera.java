package org.maestro.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.hal.Area;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.home.FloorPlan;
import org.maestro.ontology.home.Point2;
import org.maestro.ontology.home.Pose;

/**
 * A camera with colour-based detection: a cone of view, walls that hide, and light at the object
 * that decides. What is in a cupboard or in a gripper is hidden (assumed). It measures the light
 * where it looks from its images.
 */
final class SimulatedCamera implements Camera {

  private static final double COVERED = 0.95;
  private static final double GRID_METRES = 0.25;

  private final Actuator actuator;
  private final PhysicalParameters.CameraData data;
  private final Pose pose;
  private final double viewDegrees;
  private long lightVersion = -1;
  private List<AreaLight> light = List.of();

  SimulatedCamera(
      Actuator actuator, PhysicalParameters.CameraData data, Pose pose, double viewDegrees) {
    this.actuator = actuator;
    this.data = data;
    this.pose = pose;
    this.viewDegrees = viewDegrees;
  }

  @Override
  public void look(Target target, int frames, Listener listener) {
    actuator.command(
        WorldEvent.Kind.LOOK,
        frames / data.frameRate(),
        listener::failed,
        () -> listener.looked(develop(target, frames)));
  }

  private Look develop(Target target, int frames) {
    World world = actuator.world();
    Optional<Position> place =
        world
            .findBody(target.name())
            .filter(body -> !body.hidden() && body.holder().isEmpty())
            .flatMap(body -> world.position(body.name()))
            .filter(this::sees);
    double shown = place.map(point -> data.detectability(world.lux(point))).orElse(0.0);
    int detections = 0;
    for (int frame = 0; frame < frames; frame++) {
      detections += actuator.happens(shown) ? 1 : 0;
    }
    Optional<Position> measured = detections > 0 ? place.map(this::measured) : Optional.empty();
    return new Look(frames, detections, measured, estimatedLight());
  }

  /** Whether a point is in the cone of view and not behind a wall. */
  boolean sees(Position point) {
    return pose.angleTo(point.x(), point.y(), point.z()) <= viewDegrees / 2
        && !actuator.world().plan().isBlocked(pose.floor(), point.floor());
  }

  private Position measured(Position truth) {
    double error =
        data.positionError() * truth.distance(new Position(pose.x(), pose.y(), pose.z()));
    return new Position(
        truth.x() + actuator.error(error), truth.y() + actuator.error(error), truth.z());
  }

  private List<AreaLight> estimatedLight() {
    long version = actuator.world().lightVersion();
    if (version != lightVersion) {
      light = trueLight();
      lightVersion = version;
    }
    double factor = 1 + actuator.error(data.lightError());
    return light.stream()
        .map(
            area ->
                new AreaLight(
                    area.area(),
                    area.referenceLux() * factor,
                    area.darkestLux() * factor,
                    area.brightestLux() * factor))
        .toList();
  }

  private List<AreaLight> trueLight() {
    World world = actuator.world();
    FloorPlan plan = world.plan();
    List<AreaLight> areas = new ArrayList<>();
    for (Area area : world.map().areas()) {
      List<Point2> samples = area.outline().samples(GRID_METRES);
      double[] lux =
          samples.stream()
              .map(Position::onFloor)
              .filter(point -> isInView(point, plan))
              .mapToDouble(world::lux)
              .sorted()
              .toArray();
      if (lux.length > 0 && lux.length >= COVERED * samples.size()) {
        double reference = world.lux(Position.onFloor(area.reference()));
        areas.add(
            new AreaLight(
                area.name(),
                reference,
                Math.min(reference, lux[0]),
                Math.max(reference, lux[lux.length - 1])));
      }
    }
    return areas;
  }

  private boolean isInView(Position point, FloorPlan plan) {
    return pose.angleTo(point.x(), point.y(), 0) <= viewDegrees / 2
        && !plan.isBlocked(pose.floor(), point.floor());
  }

  @Override
  public double minimumLux() {
    return data.minimumLux();
  }

  @Override
  public double maximumLux() {
    return data.maximumLux();
  }

  @Override
  public double detectability(double lux) {
    return data.detectability(lux);
  }

  @Override
  public double frameRate() {
    return data.frameRate();
  }
}
