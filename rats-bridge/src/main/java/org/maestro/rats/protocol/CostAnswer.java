package org.maestro.rats.protocol;

import java.util.Optional;

/**
 * What one parameter set would cost ({@code $cost}).
 *
 * @param cost in cost units (seconds plus weighted energy); absent when the member cannot do it,
 *     then {@code reason} says why
 * @param seconds expected duration
 */
public record CostAnswer(
    Optional<Double> cost, Optional<Double> seconds, Optional<String> reason) {}
