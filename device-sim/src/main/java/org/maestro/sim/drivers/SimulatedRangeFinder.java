package org.maestro.sim.drivers;

import java.util.List;
import org.maestro.hal.Position;
import org.maestro.hal.RangeFinder;
import org.maestro.hal.Surroundings.Obstacle;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;
import org.maestro.sim.parameters.ScannerData;
import org.maestro.sim.world.Astray;
import org.maestro.sim.world.Body;
import org.maestro.sim.world.World;

/**
 * A scanner on a robot that sees what stands around it, exactly but for what the robot errs about
 * where it is itself, and knows what it is (assumed). Bodies hide nothing that is behind them
 * (assumed); walls and closed doors do.
 */
final class SimulatedRangeFinder implements RangeFinder {

  /** Of the radius: a body of which a side is in view is seen. */
  private static final double SIDE = 0.9;

  private final String robot;
  private final World world;
  private final ScannerData data;

  SimulatedRangeFinder(String robot, World world, ScannerData data) {
    this.robot = robot;
    this.world = world;
    this.data = data;
  }

  @Override
  public List<Obstacle> bodies() {
    Astray error = world.faults().astray(robot);
    return world.whereabouts().obstacles(robot).stream()
        .filter(this::isInView)
        .map(body -> new Obstacle(body.name(), error.from(body.middle()), body.radius()))
        .toList();
  }

  private boolean isInView(Obstacle body) {
    double distance = here().distance(body.middle());
    if (distance - body.radius() > data.range()) {
      return false;
    }
    if (distance <= body.radius() || isInSight(body.middle())) {
      return true;
    }
    double share = SIDE * body.radius() / distance;
    Segment sight = new Segment(here(), body.middle());
    double acrossX = -share * (sight.to().y() - sight.from().y());
    double acrossY = share * (sight.to().x() - sight.from().x());
    return isInSight(new Point2(sight.to().x() + acrossX, sight.to().y() + acrossY))
        || isInSight(new Point2(sight.to().x() - acrossX, sight.to().y() - acrossY));
  }

  @Override
  public boolean sees(Position place) {
    return place.z() < Body.OBSTACLE_METRES
        && isInSight(world.faults().astray(robot).truth(place.floor()));
  }

  private boolean isInSight(Point2 point) {
    return here().distance(point) <= data.range()
        && !world.building().plan().isBlocked(here(), point);
  }

  private Point2 here() {
    return world.position(robot).orElseThrow().floor();
  }
}
