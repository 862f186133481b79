package org.maestro.sim.drivers;

import java.util.Optional;
import java.util.function.Function;
import org.maestro.hal.Position;
import org.maestro.sim.parameters.ArmData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.Likeness;
import org.maestro.sim.world.World;

/**
 * The thing that an arm's hand is about to take, or holds. A camera on board finds the thing near
 * where it is expected. Where something is over-lit it may take another thing of the right colour
 * ({@link Likeness}), and believes then to hold the wanted one.
 */
final class Grasp {

  private final Actuator actuator;
  private final ArmData data;
  private final Likeness likeness;
  private Optional<Mistake> mistake = Optional.empty();
  private Position hand = new Position(0, 0, 0);
  private String wanted = "";

  Grasp(Actuator actuator, ArmData data, Likeness likeness) {
    this.actuator = actuator;
    this.data = data;
    this.likeness = likeness;
  }

  /** A mistaken grasp: the thing taken, and the one believed to be taken. */
  private record Mistake(String taken, String believed) {}

  void moveTo(Position place) {
    hand = place;
  }

  void aimAt(String thing) {
    wanted = thing;
  }

  /**
   * Takes what is at the hand.
   *
   * @param failing why the hand does not hold a thing
   * @return why nothing was taken; empty when it was
   */
  Optional<String> take(Function<Body, Optional<String>> failing) {
    World world = actuator.world();
    Optional<Body> expected = world.whereabouts().find(wanted);
    Optional<Body> body = expected.filter(this::isAtHand).or(() -> alike(wanted, expected));
    if (body.isEmpty()) {
      return Optional.of("it is not where it was seen");
    }
    if (body.get().mass() > data.payload()) {
      return Optional.of("it is heavier than " + data.payload() + " kg");
    }
    Optional<String> failure = failing.apply(body.get());
    if (failure.isEmpty()) {
      hold(body.get());
    }
    return failure;
  }

  private void hold(Body body) {
    World world = actuator.world();
    world.whereabouts().put(body.hidden(false).heldBy(actuator.device()));
    mistake =
        Optional.of(new Mistake(body.name(), wanted))
            .filter(taken -> !taken.taken().equals(taken.believed()));
    world.tell(WorldEvent.Kind.PICKED, actuator.device(), Optional.of(body.name()));
  }

  private boolean isAtHand(Body thing) {
    return (thing.isInTheOpen() || isInside(thing))
        && actuator.world().position(thing.name()).orElseThrow().floor().distance(hand.floor())
            <= data.graspTolerance();
  }

  /** Whether the hand is in the container in which the thing is. */
  private boolean isInside(Body thing) {
    World world = actuator.world();
    return thing.hidden()
        && thing.holder().isEmpty()
        && world.containers().at(hand).isPresent()
        && world.containers().at(hand).equals(world.containers().at(thing.position()));
  }

  /** What may be taken for the wanted thing, where the camera does not notice over-light. */
  private Optional<Body> alike(String name, Optional<Body> expected) {
    World world = actuator.world();
    if (likeness.camera().noticesGlare()) {
      return Optional.empty();
    }
    double wantedLux =
        expected
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

  /** By the name of what the hand believes to hold. */
  Optional<String> held() {
    return inHand()
        .map(
            thing ->
                mistake
                    .filter(made -> made.taken().equals(thing))
                    .map(Mistake::believed)
                    .orElse(thing));
  }

  /** Whether what it holds has room where the hand is; true when it holds nothing. */
  boolean isPlaceFree() {
    return inHand()
        .flatMap(thing -> actuator.world().whereabouts().occupant(hand, thing))
        .isEmpty();
  }

  /**
   * What it held stays where the hand is.
   *
   * @return why nothing was put down; empty when it was
   */
  Optional<String> putDown() {
    if (!isPlaceFree()) {
      return Optional.of("something stands there already");
    }
    Optional<String> thing = inHand();
    thing.ifPresent(this::putDown);
    return thing.isPresent() ? Optional.empty() : Optional.of("the hand is empty");
  }

  private void putDown(String thing) {
    World world = actuator.world();
    Optional<Position> inside = world.containers().at(hand);
    Position place =
        inside.orElseGet(
            () ->
                new Position(
                    hand.x() + actuator.error(data.placingError()),
                    hand.y() + actuator.error(data.placingError()),
                    hand.z()));
    world.whereabouts().put(world.whereabouts().body(thing).at(place).hidden(inside.isPresent()));
    world.tell(WorldEvent.Kind.PLACED, actuator.device(), Optional.of(thing));
  }

  private Optional<String> inHand() {
    return actuator.world().held(actuator.device());
  }
}
