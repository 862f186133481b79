package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.hal.Camera;
import org.maestro.hal.Photo;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.Likeness;
import org.maestro.sim.world.World;

/**
 * A camera with colour-based detection: what is in view and in what light decides. What is in a
 * cupboard or in a gripper is hidden (assumed). It reports what it believes to see, which may be
 * another thing where something is over-lit ({@link Likeness}). It measures the light where it
 * looks from its images.
 */
public final class SimulatedCamera implements Camera {

  private final Actuator actuator;
  private final CameraData data;
  private final Likeness likeness;
  private final Eye eye;
  private final ViewLight light;
  private final Shutter shutter;

  /** Takes the picture of a moment. */
  public interface Shutter {
    /**
     * @param widest pixels; no camera gives more than it has
     */
    Photo take(Duration now, int widest);
  }

  public SimulatedCamera(Actuator actuator, Likeness likeness, Eye eye, Shutter shutter) {
    this.actuator = actuator;
    this.data = likeness.camera();
    this.likeness = likeness;
    this.eye = eye;
    this.light = new ViewLight(actuator.world(), eye);
    this.shutter = shutter;
  }

  @Override
  public void look(Target target, int frames, Listener listener) {
    actuator.command(
        WorldEvent.Kind.LOOK,
        eye.turnSeconds() + eye.views().get().size() * frames / data.frameRate(),
        listener::failed,
        () -> listener.looked(asBroken(develop(target, frames))));
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

  /** Something in view that may be taken for the wanted thing. */
  private record Candidate(Position place, double chance) {}

  private Look develop(Target target, int frames) {
    World world = actuator.world();
    Optional<Position> place =
        world
            .whereabouts()
            .find(target.name())
            .filter(Body::isInTheOpen)
            .flatMap(body -> world.position(body.name()))
            .filter(this::sees);
    double lux = place.map(world::lux).orElse(0.0);
    double shown = place.isPresent() ? data.detectability(lux) : 0;
    Optional<Candidate> other = mostAlike(target.name(), lux);
    int detections = 0;
    int mistakes = 0;
    for (int frame = 0; frame < frames; frame++) {
      if (actuator.happens(shown)) {
        detections++;
      } else if (other.isPresent() && actuator.happens(other.get().chance())) {
        mistakes++;
      }
    }
    Optional<Position> believed = mistakes > detections ? other.map(Candidate::place) : place;
    int agreeing = Math.max(detections, mistakes);
    return new Look(
        frames,
        agreeing,
        agreeing > 0 ? believed.map(this::measured) : Optional.empty(),
        estimated(light.covered()),
        noticed());
  }

  private List<AreaLight> noticed() {
    List<AreaLight> areas = data.noticesGlare() ? glaring() : List.of();
    return areas.isEmpty() ? areas : estimated(areas);
  }

  private List<AreaLight> glaring() {
    return light.all().stream().filter(area -> area.brightestLux() > data.maximumLux()).toList();
  }

  private Optional<Candidate> mostAlike(String wanted, double wantedLux) {
    if (data.glare(wantedLux) < Likeness.NEVER && glaring().isEmpty()) {
      return Optional.empty();
    }
    World world = actuator.world();
    Optional<Candidate> best = Optional.empty();
    for (String name : world.bodies()) {
      Optional<Position> place =
          world
              .whereabouts()
              .find(name)
              .filter(body -> !name.equals(wanted) && body.isInTheOpen())
              .flatMap(body -> world.position(name))
              .filter(this::sees);
      if (place.isPresent()) {
        double chance =
            likeness.mistaken(
                world.looks().paint(wanted),
                wantedLux,
                world.looks().paint(name),
                world.lux(place.get()));
        Candidate candidate = new Candidate(place.get(), chance);
        if (chance > Likeness.NEVER
            && best.map(other -> isMoreAlike(candidate, other)).orElse(true)) {
          best = Optional.of(candidate);
        }
      }
    }
    return best;
  }

  /** Of two of the same colour the nearer one is the larger in the image. */
  private boolean isMoreAlike(Candidate first, Candidate second) {
    return first.chance() > second.chance()
        || first.chance() == second.chance()
            && eye.distance(first.place()) < eye.distance(second.place());
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

  private Position measured(Position truth) {
    double error = data.noise() * eye.distance(truth);
    Point2 seen = actuator.world().faults().astray(actuator.device()).from(truth.floor());
    return new Position(
        seen.x() + actuator.error(error), seen.y() + actuator.error(error), truth.z());
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
