package org.maestro.planning.api;

import org.maestro.ontology.vocabulary.FeatureType;

/**
 * A step whose price only its member knows.
 *
 * @param cost lower bound in cost units, as the member describes it
 * @param seconds as the member describes them
 */
public record OpenPrice(StepKey step, FeatureType feature, double cost, double seconds) {}
