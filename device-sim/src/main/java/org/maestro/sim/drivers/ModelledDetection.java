package org.maestro.sim.drivers;

import java.util.Optional;
import org.maestro.hal.Position;
import org.maestro.hal.Target;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.parameters.CameraData;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.Likeness;
import org.maestro.sim.world.World;

/**
 * Detection without pictures: what is in view and in what light decides, by chances. It finds what
 * it believes to see, which may be another thing where something is over-lit ({@link Likeness}).
 */
final class ModelledDetection implements Detection {

  private final Actuator actuator;
  private final CameraData data;
  private final Likeness likeness;
  private final Eye eye;
  private final ViewLight light;

  ModelledDetection(Actuator actuator, Likeness likeness, Eye eye, ViewLight light) {
    this.actuator = actuator;
    this.data = likeness.camera();
    this.likeness = likeness;
    this.eye = eye;
    this.light = light;
  }

  /** Something in view that may be taken for the wanted thing. */
  private record Candidate(Position place, double chance) {}

  @Override
  public Seen of(Target target, int frames) {
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
    return new Seen(
        agreeing, agreeing > 0 ? believed.map(this::measured) : Optional.empty(), Optional.empty());
  }

  private Optional<Candidate> mostAlike(String wanted, double wantedLux) {
    if (data.glare(wantedLux) < Likeness.NEVER && light.brighterThan(data.maximumLux()).isEmpty()) {
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

  private boolean sees(Position point) {
    return eye.sees(point, actuator.world().building().plan());
  }

  private Position measured(Position truth) {
    double error = data.noise() * eye.distance(truth);
    Point2 seen = actuator.world().faults().astray(actuator.device()).from(truth.floor());
    return new Position(
        seen.x() + actuator.error(error), seen.y() + actuator.error(error), truth.z());
  }
}
