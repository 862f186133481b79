package org.maestro.hal;

import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Segment;

/** The pose of a base on its map, and what its scanner sees ahead. */
public interface Localization {

  Point2 position();

  /** Of its front, from x towards y; radians. */
  double heading();

  /** Whether the base can go straight along there now. */
  boolean isFree(Segment ahead);
}
