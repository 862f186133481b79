package org.maestro.ontology.home;

import java.util.Optional;
import org.maestro.ontology.floor.Pose;

/** The poses of movable things, as far as anybody knows. */
@FunctionalInterface
public interface Positions {

  /** Nothing is known of movable things. */
  Positions UNKNOWN = name -> Optional.empty();

  /** The pose of a thing or device by its local name, or empty when unknown. */
  Optional<Pose> of(String name);
}
