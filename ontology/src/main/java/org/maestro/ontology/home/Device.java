package org.maestro.ontology.home;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;

/**
 * A device with the features it offers, from the home file or from the description that it sends.
 *
 * @param individual its name is the member's id on the bus
 * @param container topic of the abstraction container its agent lives in, such as {@code lights}
 * @param driver which driver kind runs it in the simulation or on hardware, such as {@code lamp}
 * @param reports what the member reports of itself: the driver's own word for a value, and the fact
 *     it means, such as {@code level} and {@code (= (level ?self) ?level)}, {@code zone} and {@code
 *     (in ?self ?zone)}
 */
public record Device(
    Individual individual,
    Optional<String> container,
    Optional<String> driver,
    List<FeatureType> features,
    Map<String, String> reports) {
  public Device {
    features = List.copyOf(features);
    reports = Collections.unmodifiableMap(new TreeMap<>(reports));
  }

  public String id() {
    return individual.name();
  }

  /**
   * Its place in stable orders ({@code maestro:order}), so that ties do not depend on names; last
   * when not stated.
   */
  public double order() {
    return individual.properties().getOrDefault("order", List.of()).stream()
        .filter(Term.Number.class::isInstance)
        .mapToDouble(term -> ((Term.Number) term).value())
        .findFirst()
        .orElse(Double.MAX_VALUE);
  }
}
