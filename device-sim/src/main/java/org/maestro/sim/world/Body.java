package org.maestro.sim.world;

import java.util.Optional;
import org.maestro.hal.Position;

/**
 * A thing, person or robot in the world.
 *
 * @param position of the middle of its foot; of what is held: where it was picked up, the holder's
 *     place counts
 * @param radius of the circle around it on the floor; metres
 * @param mass kilograms
 * @param hidden in a cupboard
 * @param holder the robot that holds it
 */
public record Body(
    String name,
    Position position,
    double radius,
    double mass,
    boolean hidden,
    Optional<String> holder) {

  /** Of a thing of which the scene says nothing else: a cup. */
  static final double USUAL_RADIUS = 0.04;

  static final double USUAL_MASS = 0.25;

  /** Things higher up than this do not stand in a robot's way; metres. */
  public static final double OBSTACLE_METRES = 0.6;

  /** Neither in a cupboard nor in a hand. */
  public boolean isInTheOpen() {
    return !hidden && holder.isEmpty();
  }

  public boolean isObstacle() {
    return isInTheOpen() && position.z() < OBSTACLE_METRES;
  }

  public Body at(Position place) {
    return new Body(name, place, radius, mass, hidden, Optional.empty());
  }

  public Body heldBy(String robot) {
    return new Body(name, position, radius, mass, hidden, Optional.of(robot));
  }

  public Body withRadius(double metres) {
    return new Body(name, position, metres, mass, hidden, holder);
  }

  public Body hidden(boolean isHidden) {
    return new Body(name, position, radius, mass, isHidden, holder);
  }
}
