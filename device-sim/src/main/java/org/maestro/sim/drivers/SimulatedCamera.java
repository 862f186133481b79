package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Flaw;
import org.maestro.sim.world.Likeness;

/**
 * A camera with colour-based detection ({@link Detection}). What is in a cupboard or in a gripper
 * is hidden (assumed). It measures the light where it looks from its images.
 */
public final class SimulatedCamera implements Camera {

  private final Actuator actuator;
  private final CameraData data;
  private final Eye eye;
  private final ViewLight light;
  private final Detection detection;
  private final Shutter shutter;

  /** Takes the picture of a moment. */
  public interface Shutter {
    /**
     * @param widest pixels; no camera gives more than it has
     */
    Photo take(Duration now, int widest);
  }

  /** One that finds things by chances. */
  public SimulatedCamera(Actuator actuator, Likeness likeness, Eye eye, Shutter shutter) {
    this(
        actuator,
        likeness.camera(),
        eye,
        light -> new ModelledDetection(actuator, likeness, eye, light),
        shutter);
  }

  /**
   * @param detection by the light in what it has in view
   */
  SimulatedCamera(
      Actuator actuator,
      CameraData data,
      Eye eye,
      Function<ViewLight, Detection> detection,
      Shutter shutter) {
    this.actuator = actuator;
    this.data = data;
    this.eye = eye;
    this.light = new ViewLight(actuator.world(), eye);
    this.detection = detection.apply(light);
    this.shutter = shutter;
  }

  @Override
  public void look(Target target, int frames, Listener listener) {
    actuator.command(
        WorldEvent.Kind.LOOK,
        eye.turnSeconds() + eye.views().get().size() * frames / data.frameRate(),
        listener::failed,
        () -> tell(detection.of(target, frames), frames, listener));
  }

  private void tell(Detection.Seen seen, int frames, Listener listener) {
    Optional<String> doubt = seen.doubt();
    if (doubt.isPresent() && saysWhatItSees()) {
      listener.doubted(doubt.get());
    } else {
      listener.looked(asBroken(develop(seen, frames)));
    }
  }

  @Override
  public void photograph(PhotoListener listener) {
    photograph(Integer.MAX_VALUE, listener);
  }

  @Override
  public void photograph(int widest, PhotoListener listener) {
    actuator.command(
        WorldEvent.Kind.LOOK,
        1 / data.frameRate(),
        listener::failed,
        () -> listener.taken(shutter.take(actuator.clock().now(), widest)));
  }

  /** What it shows now. */
  public Photo photo() {
    return shutter.take(actuator.clock().now(), Integer.MAX_VALUE);
  }

  private boolean saysWhatItSees() {
    return actuator.flaw() != Flaw.BLIND && actuator.flaw() != Flaw.SEEING_THINGS;
  }

  private Look asBroken(Look look) {
    return switch (actuator.flaw()) {
      case BLIND -> new Look(look.frames(), 0, Optional.empty(), look.areas(), look.glaring());
      case SEEING_THINGS ->
          look.position().isPresent()
              ? look
              : new Look(
                  look.frames(),
                  look.frames(),
                  Optional.of(Position.onFloor(eye.views().get().get(0).floor())),
                  look.areas(),
                  look.glaring());
      default -> look;
    };
  }

  private Look develop(Detection.Seen seen, int frames) {
    return new Look(frames, seen.detections(), seen.place(), estimated(light.covered()), noticed());
  }

  private List<AreaLight> noticed() {
    List<AreaLight> areas = data.noticesGlare() ? light.brighterThan(data.maximumLux()) : List.of();
    return areas.isEmpty() ? areas : estimated(areas);
  }

  /** From where it looks now, or begins to look around. */
  public Pose pose() {
    return eye.views().get().get(0);
  }

  /** Whether a point is in the cone of view and not behind a wall. */
  public boolean sees(Position point) {
    return eye.sees(point, actuator.world().building().plan());
  }

  @Override
  public double shareInView(String area) {
    List<Point2> samples = Eye.samples(actuator.world().building().map().area(area));
    var from = eye.views().get();
    FloorPlan plan = actuator.world().building().plan();
    long seen = samples.stream().filter(p -> eye.sees(Position.onFloor(p), from, plan)).count();
    return samples.isEmpty() ? 0 : (double) seen / samples.size();
  }

  private List<AreaLight> estimated(List<AreaLight> truth) {
    double factor = 1 + actuator.error(data.lightError());
    List<AreaLight> areas = new ArrayList<>();
    for (AreaLight area : truth) {
      areas.add(
          new AreaLight(
              area.area(),
              area.referenceLux() * factor,
              area.darkestLux() * factor,
              area.brightestLux() * factor));
    }
    return areas;
  }

  @Override
  public double minimumLux() {
    return data.minimumLux();
  }

  @Override
  public double maximumLux() {
    return data.noticesGlare() ? data.maximumLux() : Double.POSITIVE_INFINITY;
  }

  @Override
  public double detectability(double lux) {
    return data.noticesGlare() ? data.detectability(lux) : data.brightness(lux);
  }

  @Override
  public double frameRate() {
    return data.frameRate();
  }
}
