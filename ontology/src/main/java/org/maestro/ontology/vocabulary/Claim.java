package org.maestro.ontology.vocabulary;

import org.maestro.sl.Formula;
import org.maestro.sl.TypedVariable;

/**
 * The resources that a feature needs for itself while it runs, beyond its member's own components:
 * every individual that is a value of the variable under which the formula holds.
 *
 * @param when over the variable, {@code ?self}, inputs and binds
 */
public record Claim(TypedVariable variable, Formula when) {}
