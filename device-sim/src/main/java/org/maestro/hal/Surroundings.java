package org.maestro.hal;

import java.util.List;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** The floor as a mobile device knows it: its map, and what its scanners see standing there now. */
public interface Surroundings {

  /** Walls and closed doors. */
  List<Segment> walls();

  /** What stands on the floor, without the device itself and what it holds. */
  List<Obstacle> obstacles();

  List<Area> areas();

  /**
   * Something round that stands on the floor; metres.
   *
   * @param name of the thing, person or device
   */
  record Obstacle(String name, Point2 middle, double radius) {}
}
