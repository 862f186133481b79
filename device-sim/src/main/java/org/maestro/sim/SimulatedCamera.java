package org.maestro.sim;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.maestro.hal.Area;
import org.maestro.hal.Camera;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.home.FloorPlan;
import org.maestro.ontology.home.Point2;
import org.maestro.ontology.home.Pose;

/**
 * A camera with colour-based detection: a cone of view, or several that it looks along one after
 * the other while it turns, walls that hide, and light at the object that decides. What is in a
 * cupboard or in a gripper is hidden (assumed). It measures the light where it looks from its
 * images.
 */
final class SimulatedCamera implements Camera {

  private static final double COVERED = 0.95;
  private static final double GRID_METRES = 0.25;

  private final Actuator actuator;
  private final PhysicalParameters.CameraData data;
  private final Supplier<List<Pose>> views;
  private final double turnSeconds;
  private final double viewDegrees;
  private long lightVersion = -1;
  private List<Pose> lightViews = List.of();
  private List<AreaLight> light = List.of();

  SimulatedCamera(
      Actuator actuator, PhysicalParameters.CameraData data, Pose pose, double viewDegrees) {
    this(actuator, data, () -> List.of(pose), 0, viewDegrees);
  }

  private SimulatedCamera(
      Actuator actuator,
      PhysicalParameters.CameraData data,
      Supplier<List<Pose>> views,
      double turnSeconds,
      double viewDegrees) {
    this.actuator = actuator;
    this.data = data;
    this.views = views;
    this.turnSeconds = turnSeconds;
    this.viewDegrees = viewDegrees;
  }

  /** One that a device carries about, and that turns around with it for a look. */
  static SimulatedCamera onBoard(
      Actuator actuator,
      PhysicalParameters.CameraData data,
      PhysicalParameters.TurnData turn,
      double viewDegrees) {
    return new SimulatedCamera(
        actuator,
        data,
        () -> turn.views(actuator.world().position(actuator.device()).orElseThrow(), viewDegrees),
        turn.seconds(),
        viewDegrees);
  }

  @Override
  public void look(Target target, int frames, Listener listener) {
    actuator.command(
        WorldEvent.Kind.LOOK,
        turnSeconds + views.get().size() * frames / data.frameRate(),
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
    return isInView(point, views.get(), actuator.world().plan());
  }

  private boolean isInView(Position point, List<Pose> from, FloorPlan plan) {
    return from.stream()
            .anyMatch(pose -> pose.angleTo(point.x(), point.y(), point.z()) <= viewDegrees / 2)
        && !plan.isBlocked(from.get(0).floor(), point.floor());
  }

  @Override
  public double shareInView(String area) {
    List<Point2> samples = actuator.world().map().area(area).outline().samples(GRID_METRES);
    List<Pose> from = views.get();
    FloorPlan plan = actuator.world().plan();
    long seen = samples.stream().filter(p -> isInView(Position.onFloor(p), from, plan)).count();
    return samples.isEmpty() ? 0 : (double) seen / samples.size();
  }

  private Position measured(Position truth) {
    Pose pose = views.get().get(0);
    double error =
        data.positionError() * truth.distance(new Position(pose.x(), pose.y(), pose.z()));
    return new Position(
        truth.x() + actuator.error(error), truth.y() + actuator.error(error), truth.z());
  }

  private List<AreaLight> estimatedLight() {
    long version = actuator.world().lightVersion();
    List<Pose> from = views.get();
    if (version != lightVersion || !from.equals(lightViews)) {
      light = trueLight(from);
      lightVersion = version;
      lightViews = from;
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

  private List<AreaLight> trueLight(List<Pose> from) {
    World world = actuator.world();
    FloorPlan plan = world.plan();
    List<AreaLight> areas = new ArrayList<>();
    for (Area area : world.map().areas()) {
      List<Point2> samples = area.outline().samples(GRID_METRES);
      double[] lux =
          samples.stream()
              .map(Position::onFloor)
              .filter(point -> isInView(point, from, plan))
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
