package org.maestro.planning.api;

import java.util.List;
import java.util.Map;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.ontology.vocabulary.Price;
import org.maestro.sl.Term;

/**
 * A feature that a member offers, at its price.
 *
 * @param price the member's own statement
 * @param exact prices that the member has given for parameter sets (inputs and binds by name); they
 *     replace the price
 */
public record PricedFeature(
    String member, FeatureType type, Price price, Map<Map<String, Term>, ExactPrice> exact) {

  /** A price the member itself computed. {@code seconds} is the expected duration. */
  public record ExactPrice(double cost, double seconds) {}

  public List<String> parameterNames() {
    return java.util.stream.Stream.concat(type.inputs().stream(), type.binds().stream())
        .map(p -> p.name())
        .toList();
  }
}
