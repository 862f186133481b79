package org.maestro.hal;

import java.util.List;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** The floor as a mobile device knows it: its map, and what its scanners saw standing there. */
public interface Surroundings {

  /** Walls and closed doors. */
  List<Segment> walls();

  /** What stands on the floor, without the device itself and what it holds. */
  List<Obstacle> obstacles();

  List<Area> areas();

  /** Whether it would see a body now that stood there; one without eyes never does. */
  default boolean sees(Position place) {
    return false;
  }

  /**
   * What of it is so now for certain: what was seen before, and is out of sight, may be gone, and
   * doors there may have been opened.
   */
  default Surroundings inView() {
    return this;
  }

  /**
   * Something round that stands on the floor; metres.
   *
   * @param name of the thing, person or device
   */
  record Obstacle(String name, Point2 middle, double radius) {}
}
