package org.maestro.rats.protocol;

import java.util.Map;

/**
 * One value set of a continuous feature's stream; carries the call's id so that its bindings are
 * known.
 */
public record Observation(String id, String from, String feature, Map<String, Object> values) {}
