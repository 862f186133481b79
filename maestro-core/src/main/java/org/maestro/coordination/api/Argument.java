package org.maestro.coordination.api;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.maestro.sl.Term;

/**
 * A parameter's value as it travels to a member (Three-layered architecture, 3.2.3; M58).
 *
 * @param iri of the individual that the value points to
 * @param properties what the feature's input needs of it, by local name
 */
public record Argument(Term value, Optional<String> iri, Map<String, List<Term>> properties) {}
