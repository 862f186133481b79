package org.maestro.ontology.home;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.ontology.vocabulary.Vocabulary;

/**
 * A home: the map and the devices, with the vocabulary that describes them. Keyed by local name.
 * Immutable; devices are among the individuals too.
 */
public record Home(
    String iri,
    String label,
    Vocabulary vocabulary,
    Map<String, Individual> individuals,
    Map<String, Device> devices) {
  public Home {
    individuals = Collections.unmodifiableMap(new TreeMap<>(individuals));
    devices = Collections.unmodifiableMap(new TreeMap<>(devices));
  }
}
