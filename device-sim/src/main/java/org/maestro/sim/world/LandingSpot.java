package org.maestro.sim.world;

import java.util.List;
import org.maestro.hal.Position;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;

/** The landing spot of a thing that a robot lets go of: beside it, on free floor of its room. */
final class LandingSpot {

  private static final double DISTANCE_METRES = 0.1;
  private static final int DIRECTIONS = 8;

  private LandingSpot() {}

  static Position beside(
      Point2 robot, double radius, List<Obstacle> obstacles, FloorMap map, FloorPlan plan) {
    double distance = radius + DISTANCE_METRES;
    for (int i = 0; i < DIRECTIONS; i++) {
      double angle = 2 * Math.PI * i / DIRECTIONS;
      Point2 place =
          new Point2(
              robot.x() + distance * Math.cos(angle), robot.y() + distance * Math.sin(angle));
      boolean free =
          obstacles.stream()
              .allMatch(
                  obstacle ->
                      obstacle.middle().distance(place) > obstacle.radius() + DISTANCE_METRES);
      if (free && map.areaAt(place).isPresent() && !plan.isBlocked(robot, place)) {
        return Position.onFloor(place);
      }
    }
    return Position.onFloor(robot);
  }
}
