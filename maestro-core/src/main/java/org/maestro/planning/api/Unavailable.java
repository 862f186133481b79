package org.maestro.planning.api;

/**
 * A feature that could take part if its member were there or willing. Plans never use it;
 * explanations name it as a cure.
 *
 * @param feature at the price of its description
 * @param reason why it cannot be counted on: {@code lost since 12 s (no power)}, {@code refuses: I
 *     am charging}
 */
public record Unavailable(PricedFeature feature, String reason) {}
