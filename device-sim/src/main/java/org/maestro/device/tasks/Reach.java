package org.maestro.device.tasks;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import org.maestro.device.navigation.Route;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.hal.Area;
import org.maestro.hal.Surroundings;
import org.maestro.ontology.floor.Point2;

/**
 * The stands from which a robot reaches a spot of the floor, and the spots beside a thing where it
 * can put something down. Clock thread only.
 */
final class Reach {

  /** A spot beside a thing is this far from its middle, if the thing is not too thick; metres. */
  private static final double USUAL_DISTANCE = 0.4;

  /** Farther is no longer beside it, given that positions are known to some centimetres; metres. */
  static final double GREATEST_DISTANCE = 0.5;

  /** What a gripper holds is no thicker (radius), and stays so far from everything else; metres. */
  private static final double HELD_RADIUS = 0.05;

  private static final double MARGIN = 0.04;
  private static final double SPOT_CLEARANCE = HELD_RADIUS + MARGIN;
  private static final double GRID_METRES = 0.25;

  private final Robot robot;
  private final double reach;
  private WalledFloor held = new WalledFloor(List.of(), SPOT_CLEARANCE);

  Reach(Robot robot, double reach) {
    this.robot = robot;
    this.reach = reach;
  }

  /** The way to a stand, and the spot to reach from there. */
  record Approach(Route route, Point2 spot) {}

  /** The nearest stand from which the spot is reached. */
  Optional<Approach> to(Point2 spot) {
    return nearest(List.of(spot));
  }

  /** The nearest stand from which a free spot beside the thing is reached. */
  Optional<Approach> beside(Point2 thing) {
    double thickness =
        robot.surroundings().obstacles().stream()
            .filter(obstacle -> obstacle.middle().distance(thing) <= obstacle.radius())
            .mapToDouble(obstacle -> obstacle.radius() + obstacle.middle().distance(thing))
            .max()
            .orElse(0);
    double distance = Math.max(USUAL_DISTANCE, thickness + SPOT_CLEARANCE);
    return distance > GREATEST_DISTANCE
        ? Optional.empty()
        : nearest(freeOnes(robot.around(thing, distance)));
  }

  /**
   * The nearest stand from which a free spot of the area is reached; where the robot stands, if it
   * can.
   */
  Optional<Approach> within(Area area) {
    List<Point2> spots = new ArrayList<>(robot.around(robot.base().position(), reach));
    spots.addAll(area.outline().samples(GRID_METRES));
    spots.removeIf(spot -> !area.outline().contains(spot));
    return nearest(freeOnes(spots));
  }

  /** A free spot that is reached without driving. */
  Optional<Point2> here() {
    return freeOnes(robot.around(robot.base().position(), reach)).stream().findFirst();
  }

  private Optional<Approach> nearest(List<Point2> spots) {
    Map<Point2, Point2> spotOfStand = new LinkedHashMap<>();
    Point2 position = robot.base().position();
    for (Point2 spot : spots) {
      if (Math.abs(position.distance(spot) - reach) <= MARGIN) {
        spotOfStand.putIfAbsent(position, spot);
      }
      robot.around(spot, reach).forEach(stand -> spotOfStand.putIfAbsent(stand, spot));
    }
    return robot
        .routeToNearest(List.copyOf(spotOfStand.keySet()))
        .map(
            route ->
                new Approach(route, Objects.requireNonNull(spotOfStand.get(route.end(position)))));
  }

  private List<Point2> freeOnes(List<Point2> spots) {
    List<Point2> free = freeOnes(spots, robot.surroundings());
    return free.isEmpty() ? freeOnes(spots, robot.surroundings().inView()) : free;
  }

  private List<Point2> freeOnes(List<Point2> spots, Surroundings amid) {
    held = held.with(amid.walls());
    RoutePlanner body = new RoutePlanner(held, amid.obstacles());
    return spots.stream().filter(spot -> body.isFree(spot) && robot.isOnMap(spot)).toList();
  }
}
