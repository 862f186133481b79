package org.maestro.coordination.achievement;

import java.util.Map;
import org.maestro.sl.Term;

/**
 * A call of one feature of one member, as a script asks for it.
 *
 * @param parameters by name; what is left out is chosen when it is called
 */
public record FeatureCall(String feature, String member, Map<String, Term> parameters) {
  public FeatureCall {
    parameters = Map.copyOf(parameters);
  }
}
