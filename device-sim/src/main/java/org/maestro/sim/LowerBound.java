package org.maestro.sim;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.maestro.device.navigation.Route;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;
import org.maestro.sim.drivers.SimulatedArm;
import org.maestro.sim.parameters.ArmData;
import org.maestro.sim.parameters.GripperData;
import org.maestro.sim.parameters.PhysicalParameters;
import org.maestro.sim.scene.SimulationException;
import org.maestro.sim.world.World;

/**
 * The least time in which a robot could bring a thing next to another: shortest ways at full speed,
 * one grip and one placing, everything being known. Ways are found as robots find theirs, so that
 * none is shorter.
 */
final class LowerBound {

  private static final double NANOS = 1e9;
  private static final int STANDS = 48;

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
    double reach = parameters.arm().reach() + SimulatedArm.SLACK_METRES;
    RoutePlanner routes =
        new RoutePlanner(
            world.building().walls(),
            world.whereabouts().obstacles(robot),
            parameters.base().radius());
    Point2 start = place(robot);
    Point2 end = place(target);
    double least = Double.POSITIVE_INFINITY;
    for (Point2 stand : stands(place(thing), reach, start)) {
      Optional<Route> first = routes.shortest(start, List.of(stand));
      Optional<Route> second =
          routes.shortest(stand, stands(end, reach + World.NEXT_TO_METRES, stand));
      if (first.isPresent() && second.isPresent()) {
        least = Math.min(least, first.get().length() + second.get().length());
      }
    }
    if (Double.isInfinite(least)) {
      throw new SimulationException(
          "There is no way for " + robot + " to " + thing + " and on to " + target + ".");
    }
    ArmData arm = parameters.arm();
    GripperData gripper = parameters.gripper();
    double seconds =
        least / parameters.base().speed()
            + arm.extendSeconds()
            + gripper.pressSeconds()
            + gripper.evacuateSeconds()
            + arm.foldSeconds()
            + arm.extendSeconds()
            + gripper.inflateSeconds();
    return Duration.ofNanos(Math.round(seconds * NANOS));
  }

  /**
   * Where one could stand to reach a place: on the circle around it, or where one is if that is
   * near enough.
   */
  private static List<Point2> stands(Point2 middle, double distance, Point2 present) {
    if (present.distance(middle) <= distance) {
      return List.of(present);
    }
    List<Point2> stands = new ArrayList<>();
    for (int i = 0; i < STANDS; i++) {
      double angle = 2 * Math.PI * i / STANDS;
      stands.add(
          new Point2(
              middle.x() + distance * Math.cos(angle), middle.y() + distance * Math.sin(angle)));
    }
    return stands;
  }

  private Point2 place(String name) {
    return world
        .position(name)
        .map(Position::floor)
        .orElseThrow(() -> new SimulationException(name + " is nowhere in this world."));
  }
}
