package org.maestro.rats.conformance;

import java.util.Map;

/**
 * A call of a feature that may be made.
 *
 * @param parameters JSON values
 */
public record FeatureCall(String feature, Map<String, Object> parameters) {}
