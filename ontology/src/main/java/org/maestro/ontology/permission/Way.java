package org.maestro.ontology.permission;

import java.util.Map;
import org.maestro.ontology.home.Device;
import org.maestro.ontology.vocabulary.FeatureType;
import org.maestro.sl.Term;

/**
 * A feature of a device that brings a part of a goal about.
 *
 * @param values of the feature's parameters, as far as the goal decides them
 * @param number the parameter that becomes the goal's number; "" where it wants none
 */
public record Way(Device device, FeatureType feature, Map<String, Term> values, String number) {
  public Way {
    values = Map.copyOf(values);
  }
}
