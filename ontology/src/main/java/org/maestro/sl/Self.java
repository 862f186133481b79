package org.maestro.sl;

import java.util.HashMap;
import java.util.Map;

/**
 * The individual whose feature or wish a formula is part of: in the formula it is {@code ?self}.
 */
public final class Self {
  /** Its variable's name. */
  public static final String NAME = "self";

  public static final Term.Variable VARIABLE = new Term.Variable(NAME);

  private Self() {}

  /** Bindings by which it is the named individual. */
  public static Map<String, Term> is(String individual) {
    return Map.of(NAME, new Term.Name(individual));
  }

  /**
   * The same with others beside it.
   *
   * @return a map of the caller's own, that may be changed
   */
  public static Map<String, Term> is(String individual, Map<String, Term> others) {
    Map<String, Term> bindings = new HashMap<>(others);
    bindings.put(NAME, new Term.Name(individual));
    return bindings;
  }
}
