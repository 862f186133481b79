package org.maestro.sim.scene;

import java.util.List;
import org.maestro.ontology.validation.Fault;

/**
 * What is to be said of a scene.
 *
 * @param faults with one of them it cannot be simulated
 * @param warnings what in it is hardly meant so
 */
public record CheckedScene(List<Fault> faults, List<Fault> warnings) {
  public CheckedScene {
    faults = List.copyOf(faults);
    warnings = List.copyOf(warnings);
  }
}
