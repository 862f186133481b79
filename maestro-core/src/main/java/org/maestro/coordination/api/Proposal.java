package org.maestro.coordination.api;

import java.util.Map;
import java.util.Optional;
import org.maestro.ontology.vocabulary.Price;

/**
 * A member's answer to a call for prices.
 *
 * @param prices by feature name; empty with a refusal
 */
public record Proposal(String member, Map<String, Price> prices, Optional<String> refusal) {}
