package org.maestro.sim;

import java.util.Optional;
import org.maestro.hal.Completion;
import org.maestro.hal.GripperArm;
import org.maestro.hal.Position;
import org.maestro.hal.Target;

/**
 * An arm with a jamming gripper; a camera on board finds the thing near where it is expected. Where
 * something is over-lit it may take another thing of the right colour ({@link Likeness}), and
 * believes then to hold the wanted one.
 */
final class SimulatedArm implements GripperArm {

  /** The base stands where it was sent; the arm evens out so much of distance. */
  static final double SLACK_METRES = 0.06;

  private final Actuator actuator;
  private final ArmData data;
  private final Likeness likeness;
  private Optional<Mistake> mistake = Optional.empty();
  private Position hand = new Position(0, 0, 0);
  private long commandNumber;

  SimulatedArm(Actuator actuator, ArmData data, Likeness likeness) {
    this.actuator = actuator;
    this.data = data;
    this.likeness = likeness;
  }

  /** What was taken, and what for. */
  private record Mistake(String taken, String believed) {}

  @Override
  public void extend(Position place, Completion completion) {
    run(
        data.extendSeconds(),
        completion,
        () -> {
          double distance = robot().floor().distance(place.floor());
          if (distance > data.reach() + SLACK_METRES) {
            completion.failed("it is out of reach");
          } else {
            hand = place;
            completion.done();
          }
        });
  }

  @Override
  public void open(Completion completion) {
    run(0, completion, completion::done);
  }

  @Override
  public void grasp(Target target, Completion completion) {
    actuator.tell(WorldEvent.Kind.GRASP);
    run(data.graspSeconds(), completion, () -> close(target, completion));
  }

  private void close(Target target, Completion completion) {
    World world = actuator.world();
    Optional<Body> wanted = world.whereabouts().find(target.name());
    Optional<Body> body = wanted.filter(this::isAtHand).or(() -> alike(target.name(), wanted));
    if (body.isEmpty()) {
      completion.failed("it is not where it was seen");
    } else if (body.get().mass() > data.payload()) {
      completion.failed("it is heavier than " + data.payload() + " kg");
    } else {
      world.whereabouts().put(body.get().heldBy(actuator.device()));
      mistake =
          Optional.of(new Mistake(body.get().name(), target.name()))
              .filter(taken -> !taken.taken().equals(taken.believed()));
      world.tell(WorldEvent.Kind.PICKED, actuator.device(), Optional.of(body.get().name()));
      if (world.isAlive(actuator.device())) {
        completion.done();
      }
    }
  }

  private boolean isAtHand(Body thing) {
    return thing.isObstacle()
        && actuator.world().position(thing.name()).orElseThrow().floor().distance(hand.floor())
            <= data.graspTolerance();
  }

  /** What may be taken for the wanted thing, where the camera does not notice over-light. */
  private Optional<Body> alike(String name, Optional<Body> wanted) {
    World world = actuator.world();
    if (likeness.camera().noticesGlare()) {
      return Optional.empty();
    }
    double wantedLux =
        wanted
            .filter(Body::isInTheOpen)
            .flatMap(body -> world.position(name))
            .map(world::lux)
            .orElse(0.0);
    for (String other : world.bodies()) {
      Optional<Body> body =
          world.whereabouts().find(other).filter(thing -> !other.equals(name) && isAtHand(thing));
      if (body.isPresent()
          && actuator.happens(
              likeness.mistaken(
                  world.looks().paint(name),
                  wantedLux,
                  world.looks().paint(other),
                  world.lux(world.position(other).orElseThrow())))) {
        return body;
      }
    }
    return Optional.empty();
  }

  @Override
  public boolean isPlaceFree() {
    World world = actuator.world();
    return world
        .held(actuator.device())
        .flatMap(thing -> world.whereabouts().occupant(hand, thing))
        .isEmpty();
  }

  @Override
  public void release(Completion completion) {
    actuator.tell(WorldEvent.Kind.RELEASE);
    run(
        data.releaseSeconds(),
        completion,
        () -> {
          Optional<String> thing = actuator.world().held(actuator.device());
          if (!isPlaceFree()) {
            completion.failed("something stands there already");
          } else if (thing.isPresent()) {
            putDown(thing.get());
            completion.done();
          } else {
            completion.failed("the hand is empty");
          }
        });
  }

  private void putDown(String thing) {
    World world = actuator.world();
    Position place =
        new Position(
            hand.x() + actuator.error(data.placingError()),
            hand.y() + actuator.error(data.placingError()),
            hand.z());
    world.whereabouts().put(world.whereabouts().body(thing).at(place));
    world.tell(WorldEvent.Kind.PLACED, actuator.device(), Optional.of(thing));
  }

  @Override
  public void fold(Completion completion) {
    run(data.foldSeconds(), completion, completion::done);
  }

  private void run(double seconds, Completion completion, Runnable effect) {
    long number = ++commandNumber;
    actuator.world().batteries().draw(actuator.device(), seconds * data.power());
    actuator.after(
        seconds,
        () -> {
          if (number != commandNumber) {
            return;
          }
          Optional<String> defect = actuator.world().faults().defect(actuator.device());
          if (defect.isPresent()) {
            completion.failed(defect.get());
          } else {
            effect.run();
          }
        });
  }

  private Position robot() {
    return actuator.world().position(actuator.device()).orElseThrow();
  }

  @Override
  public Optional<String> held() {
    return actuator
        .world()
        .held(actuator.device())
        .map(
            thing ->
                mistake
                    .filter(made -> made.taken().equals(thing))
                    .map(Mistake::believed)
                    .orElse(thing));
  }

  @Override
  public double reach() {
    return data.reach();
  }

  @Override
  public double payload() {
    return data.payload();
  }

  @Override
  public double pickSeconds() {
    return data.pickSeconds();
  }

  @Override
  public double placeSeconds() {
    return data.placeSeconds();
  }

  @Override
  public double power() {
    return data.power();
  }
}
