package org.maestro.ontology.home;

import java.util.Collections;
import java.util.Map;
import java.util.TreeMap;
import org.maestro.ontology.vocabulary.Vocabulary;

/**
 * A home: the map and the devices, with the vocabulary that describes them. Keyed by local name.
 * Immutable; devices and group agents are among the individuals too.
 *
 * @param words what its file adds to the vocabulary that is shipped, as Turtle; empty when it adds
 *     nothing
 */
public record Home(
    String iri,
    String label,
    Vocabulary vocabulary,
    Map<String, Individual> individuals,
    Map<String, Device> devices,
    Map<String, Group> groups,
    String words) {
  public Home {
    individuals = Collections.unmodifiableMap(new TreeMap<>(individuals));
    devices = Collections.unmodifiableMap(new TreeMap<>(devices));
    groups = Collections.unmodifiableMap(new TreeMap<>(groups));
  }

  /** A home without words of its own. */
  public Home(
      String iri,
      String label,
      Vocabulary vocabulary,
      Map<String, Individual> individuals,
      Map<String, Device> devices,
      Map<String, Group> groups) {
    this(iri, label, vocabulary, individuals, devices, groups, "");
  }

  /** A home without group agents and words of its own. */
  public Home(
      String iri,
      String label,
      Vocabulary vocabulary,
      Map<String, Individual> individuals,
      Map<String, Device> devices) {
    this(iri, label, vocabulary, individuals, devices, Map.of());
  }

  /** The same home with this device, or with what it now says of itself. */
  public Home with(Device device) {
    Map<String, Individual> things = new TreeMap<>(individuals);
    things.put(device.id(), device.individual());
    Map<String, Device> joined = new TreeMap<>(devices);
    joined.put(device.id(), device);
    return new Home(iri, label, vocabulary, things, joined, groups, words);
  }
}
