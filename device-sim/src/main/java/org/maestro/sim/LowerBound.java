package org.maestro.sim;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import org.maestro.device.RoutePlanner;
import org.maestro.ontology.home.Point2;

/**
 * The least time that physics allows: straight to the things, at full speed, one grip and one
 * placing, nothing to be looked for.
 */
final class LowerBound {

  private static final double NANOS = 1e9;

  private final World world;
  private final PhysicalParameters parameters;

  LowerBound(World world, PhysicalParameters parameters) {
    this.world = world;
    this.parameters = parameters;
  }

  /**
   * @throws SimulationException when one of them is nowhere, or there is no way
   */
  Duration bringNextTo(String robot, String thing, String target) {
    if (world.isNextTo(thing, target)) {
      return Duration.ZERO;
    }
    double reach = parameters.arm().reach() + parameters.arm().graspTolerance();
    double toThing = Math.max(0, way(robot, thing, Set.of(robot, thing, target)) - reach);
    double toTarget =
        Math.max(
            0, way(thing, target, Set.of(robot, thing, target)) - 2 * reach - World.NEXT_TO_METRES);
    double seconds =
        (toThing + toTarget) / parameters.base().speed()
            + parameters.arm().extendSeconds()
            + parameters.arm().graspSeconds()
            + parameters.arm().foldSeconds()
            + parameters.arm().extendSeconds()
            + parameters.arm().releaseSeconds();
    return Duration.ofNanos(Math.round(seconds * NANOS));
  }

  /** The way of a point among walls only: no body can take a shorter one. */
  private double way(String from, String to, Set<String> without) {
    RoutePlanner point = new RoutePlanner(world.walls(), world.obstaclesWithout(without), 0.01);
    return point
        .shortest(place(from), List.of(place(to)))
        .orElseThrow(
            () -> new SimulationException("There is no way from " + from + " to " + to + "."))
        .length();
  }

  private Point2 place(String name) {
    return world
        .position(name)
        .orElseThrow(() -> new SimulationException(name + " is nowhere in this world."))
        .floor();
  }
}
