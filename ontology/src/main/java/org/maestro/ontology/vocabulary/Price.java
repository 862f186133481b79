package org.maestro.ontology.vocabulary;

import org.maestro.sl.Expression;

/**
 * The cost of a feature (Three-layered architecture, 3.2.2; M53): computable by anybody, or only by
 * the member itself.
 */
public sealed interface Price {

  /** A constant or an expression over the facts and the feature's parameters. */
  record Stated(Expression cost) implements Price {}

  /** Only the member can say ({@code $cost}); never less than the given expression. */
  record Asked(Expression atLeast) implements Price {}
}
