package org.maestro.planning.api;

import java.util.Map;
import java.util.Set;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;

/**
 * One step of a plan.
 *
 * @param number from 1, its place in a valid total order
 * @param bindings values of all inputs and binds by parameter name, {@code ?self} not among them
 * @param cost in cost units; a lower bound unless {@code exactPrice}
 * @param after numbers of the steps that must be done before it starts
 */
public record Step(
    int number,
    String member,
    FeatureType feature,
    Map<String, Term> bindings,
    double cost,
    double seconds,
    boolean exactPrice,
    Set<Integer> after) {

  public StepKey key() {
    return new StepKey(member, feature.name(), bindings);
  }

  /** What the variables of its feature stand for, {@code ?self} among them. */
  public Map<String, Term> values() {
    return key().values();
  }
}
