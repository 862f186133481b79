package org.maestro.rats.protocol;

import java.util.Optional;

/**
 * The expected cost of one parameter set ({@code $cost}).
 *
 * @param cost in cost units (seconds plus weighted energy); absent when the member cannot do it,
 *     then {@code reason} says why
 * @param seconds expected duration
 * @param answered false when the member did not say anything usable: it may well be able to do it
 */
public record CostAnswer(
    Optional<Double> cost, Optional<Double> seconds, Optional<String> reason, boolean answered) {

  /** What the member itself says. */
  public CostAnswer(Optional<Double> cost, Optional<Double> seconds, Optional<String> reason) {
    this(cost, seconds, reason, true);
  }

  /** Nothing came of the question. */
  public static CostAnswer unanswered(String reason) {
    return new CostAnswer(Optional.empty(), Optional.empty(), Optional.of(reason), false);
  }
}
