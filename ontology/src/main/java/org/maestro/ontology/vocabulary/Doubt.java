package org.maestro.ontology.vocabulary;

import org.maestro.sl.Formula;

/**
 * The greatest confidence in a feature's results, under a condition.
 *
 * @param confidence 0 (worthless) to 1 (certain)
 * @param when the formula over {@code ?self}, inputs and binds under which it is no surer
 */
public record Doubt(double confidence, Formula when) {}
