package org.maestro.ontology.home;

import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.Expression;

/**
 * The worth of a script, or of each goal that an agent has of its own accord, as far as it is
 * stated (ADE, 4.1; A52, A53).
 *
 * @param benefit in seconds of work
 * @param chance that it succeeds, 0 to 1, as long as it was never tried
 * @param allowed simulated time within which its urgency grows to the highest
 */
public record StatedWorth(
    Optional<Expression> benefit, Optional<Double> chance, Optional<Duration> allowed) {
  /** Nothing is said of it. */
  public static final StatedWorth NONE =
      new StatedWorth(Optional.empty(), Optional.empty(), Optional.empty());

  /** The same, with what another says where this says nothing. */
  StatedWorth or(StatedWorth other) {
    return new StatedWorth(
        benefit.or(other::benefit), chance.or(other::chance), allowed.or(other::allowed));
  }
}
