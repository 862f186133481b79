package org.maestro.assembly;

import java.util.List;
import java.util.Set;
import org.maestro.device.navigation.RoutePlanner;
import org.maestro.device.navigation.WalledFloor;
import org.maestro.hal.Area;
import org.maestro.hal.Surroundings;
import org.maestro.ontology.floor.Segment;
import org.maestro.ontology.home.Home;
import org.maestro.sim.world.FloorMap;

/** The floor as the home's file has it: walls, doors closed, and nothing that stands on it. */
final class HomeFloor implements Surroundings {
  private final List<Segment> walls;
  private final List<Area> areas;

  HomeFloor(Home home) {
    FloorMap map = new FloorMap(home);
    this.walls = map.plan(Set.of()).walls();
    this.areas = map.areas();
  }

  boolean isFree(Segment ahead, double radius) {
    return new RoutePlanner(new WalledFloor(walls, radius), List.of())
        .isFreeWay(ahead.from(), ahead.to());
  }

  @Override
  public List<Segment> walls() {
    return walls;
  }

  @Override
  public List<Obstacle> obstacles() {
    return List.of();
  }

  @Override
  public List<Area> areas() {
    return areas;
  }
}
