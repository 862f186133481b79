package org.maestro.ontology.home;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import org.maestro.sl.Term;

/**
 * A thing of a home: a person, an object, a room, a zone, a door or a device.
 *
 * @param name local name, unique in the home
 * @param classes local names of all its classes, superclasses included
 * @param properties values by the property's local name: numbers, names, texts (poses, outlines),
 *     truths
 */
public record Individual(
    String name,
    String iri,
    String label,
    Set<String> classes,
    Map<String, List<Term>> properties) {
  /** The property that tells the place in stable orders; it says nothing of the thing itself. */
  public static final String ORDER = "order";

  public Individual {
    // In a stable order, and looked up by their hashes: words are held against many thousands.
    classes = Collections.unmodifiableSet(new LinkedHashSet<>(new TreeSet<>(classes)));
    properties = Collections.unmodifiableMap(new LinkedHashMap<>(new TreeMap<>(properties)));
  }

  /**
   * Its place in stable orders ({@code maestro:order}), so that ties do not depend on names; last
   * when not stated.
   */
  public double order() {
    return values(ORDER).stream()
        .filter(Term.Number.class::isInstance)
        .mapToDouble(term -> ((Term.Number) term).value())
        .findFirst()
        .orElse(Double.MAX_VALUE);
  }

  /** What is stated of it under this property; empty when nothing is. */
  List<Term> values(String property) {
    return properties.getOrDefault(property, List.of());
  }
}
