package org.maestro.sim.drivers;

import java.time.Duration;
import java.util.Optional;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.sim.world.Drive;
import org.maestro.sim.world.World;

/**
 * Collisions ahead of a robot that drives: other bodies that move and that it will run into, as its
 * scanner sees them.
 */
final class Encounters {

  private static final int MOMENTS = 5;
  private static final double NANOS = 1e9;

  /** As {@link SimulatedBase} passes obstacles. */
  private static final double GRAZING_METRES = 0.01;

  private Encounters() {}

  /**
   * @param way straight on from where the robot is, within so many seconds
   */
  static boolean isAhead(World world, String robot, double radius, Segment way, double seconds) {
    for (String other : world.whereabouts().movingWithout(robot)) {
      Optional<Drive> drive = world.whereabouts().drive(other);
      if (drive.isPresent()
          && comesNearer(world, radius + world.radius(other), drive.get(), way, seconds)) {
        return true;
      }
    }
    return false;
  }

  private static boolean comesNearer(
      World world, double apart, Drive other, Segment way, double seconds) {
    double before = way.from().distance(other.positionAt(world.now()));
    for (int i = 1; i <= MOMENTS; i++) {
      double share = (double) i / MOMENTS;
      Duration then = world.now().plusNanos(Math.round(share * seconds * NANOS));
      Point2 here = way.at(share);
      double distance = here.distance(other.positionAt(then));
      if (distance < apart - GRAZING_METRES && distance < before) {
        return true;
      }
    }
    return false;
  }

  /** Another body that moves and that the robot touches now. */
  static Optional<String> touched(World world, String robot, double radius) {
    Point2 here = world.position(robot).map(Position::floor).orElseThrow();
    return world.whereabouts().movingWithout(robot).stream()
        .filter(
            other ->
                world.position(other).orElseThrow().floor().distance(here)
                    < radius + world.radius(other) - GRAZING_METRES)
        .findFirst();
  }
}
