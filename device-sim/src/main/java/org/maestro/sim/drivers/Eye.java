package org.maestro.sim.drivers;

import java.util.List;
import java.util.function.Supplier;
import org.maestro.hal.Area;
import org.maestro.hal.Position;
import org.maestro.ontology.floor.FloorPlan;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Pose;
import org.maestro.sim.parameters.TurnData;

/**
 * A camera's field of view: a cone, or several along which it looks one after the other while it
 * turns. Walls hide.
 *
 * @param views from one place
 * @param turnSeconds for turning on the way from the first to the last
 * @param viewDegrees full angle of a cone
 */
public record Eye(Supplier<List<Pose>> views, double turnSeconds, double viewDegrees) {

  private static final double GRID_METRES = 0.25;

  public static Eye fixed(Pose pose, double viewDegrees) {
    List<Pose> only = List.of(pose);
    return new Eye(() -> only, 0, viewDegrees);
  }

  /** One that a device carries about, and that turns around with it for a look. */
  public static Eye onBoard(Actuator actuator, TurnData turn, double viewDegrees) {
    return new Eye(
        () -> turn.views(actuator.world().position(actuator.device()).orElseThrow(), viewDegrees),
        turn.seconds(),
        viewDegrees);
  }

  boolean sees(Position point, FloorPlan plan) {
    return sees(point, views.get(), plan);
  }

  boolean sees(Position point, List<Pose> from, FloorPlan plan) {
    return from.stream()
            .anyMatch(pose -> pose.angleTo(point.x(), point.y(), point.z()) <= viewDegrees / 2)
        && !plan.isBlocked(from.get(0).floor(), point.floor());
  }

  double distance(Position point) {
    Pose pose = views.get().get(0);
    return point.distance(new Position(pose.x(), pose.y(), pose.z()));
  }

  /** Points all over an area, by which the light and the share of it in view are found. */
  static List<Point2> samples(Area area) {
    return area.outline().samples(GRID_METRES);
  }
}
