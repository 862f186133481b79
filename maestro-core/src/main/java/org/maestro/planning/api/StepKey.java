package org.maestro.planning.api;

import java.util.Map;
import org.maestro.sl.Self;
import org.maestro.sl.Term;

/** A feature instance: who does what with which inputs and bindings. */
public record StepKey(String member, String feature, Map<String, Term> bindings) {

  /** What the variables of the feature stand for, {@code ?self} among them. */
  public Map<String, Term> values() {
    return Self.is(member, bindings);
  }
}
