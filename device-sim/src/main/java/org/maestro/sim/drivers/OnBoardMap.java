package org.maestro.sim.drivers;

import java.util.List;
import org.maestro.hal.Area;
import org.maestro.hal.Surroundings;
import org.maestro.ontology.floor.Segment;
import org.maestro.sim.world.World;

/**
 * A robot's map with laser scanner: it sees all that stands on the floor, exactly and everywhere,
 * and knows what it is (assumed).
 */
final class OnBoardMap implements Surroundings {

  private final String robot;
  private final World world;

  OnBoardMap(String robot, World world) {
    this.robot = robot;
    this.world = world;
  }

  @Override
  public List<Segment> walls() {
    return world.building().walls();
  }

  @Override
  public List<Obstacle> obstacles() {
    return world.whereabouts().obstacles(robot);
  }

  @Override
  public List<Area> areas() {
    return world.building().map().areas();
  }
}
