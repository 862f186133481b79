package org.maestro.ontology.home;

import java.util.List;
import org.maestro.ontology.validation.Fault;

/**
 * A home without faults.
 *
 * @param warnings what in it is hardly meant so, though the home can be used, by line
 */
public record CheckedHome(Home home, List<Fault> warnings) {
  public CheckedHome {
    warnings = List.copyOf(warnings);
  }
}
