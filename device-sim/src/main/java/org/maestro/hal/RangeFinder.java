package org.maestro.hal;

import java.util.List;
import org.maestro.hal.Surroundings.Obstacle;

/**
 * A scanner that looks all around over the floor, as far as it reaches and nothing hides what is
 * behind, with the software that tells bodies apart.
 */
public interface RangeFinder {

  /** The bodies that it sees now, without the device itself and what it holds. */
  List<Obstacle> bodies();

  /**
   * Whether it would see a body that stood there: the place is in reach and not too high, and no
   * wall or closed door hides it.
   */
  boolean sees(Position place);
}
