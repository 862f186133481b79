package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Optional;
import java.util.function.UnaryOperator;
import org.maestro.ontology.home.StatedWorth;
import org.maestro.sl.Expression;

/**
 * The stakes of a goal, as its requester states them (ADE, 4.1; A52, A53).
 *
 * @param benefit of having it reached, in the unit of costs, seconds of work; looked at anew
 *     whenever a fact under it changes
 * @param chance that it is reached, 0 to 1, as long as nothing like it was tried
 * @param allowed simulated time within which its urgency grows from the one bound to the other;
 *     empty: until its deadline, and not at all without one
 * @param urgencyFrom at the beginning, above 0
 * @param urgencyTo when that time has passed, no less
 */
public record Stakes(
    Expression benefit,
    double chance,
    Optional<Duration> allowed,
    double urgencyFrom,
    double urgencyTo) {
  public static final double USUAL_CHANCE = 0.8;
  public static final double USUAL_URGENCY_FROM = 1;
  public static final double USUAL_URGENCY_TO = 10;

  /** Stakes of which only the benefit is stated. */
  public Stakes(Expression benefit) {
    this(benefit, USUAL_CHANCE, Optional.empty(), USUAL_URGENCY_FROM, USUAL_URGENCY_TO);
  }

  /**
   * Stakes as a home states them; none without a benefit.
   *
   * @param applied the benefit with values for its variables
   */
  public static Optional<Stakes> of(StatedWorth stated, UnaryOperator<Expression> applied) {
    return stated
        .benefit()
        .map(
            benefit ->
                new Stakes(
                    applied.apply(benefit),
                    stated.chance().orElse(USUAL_CHANCE),
                    stated.allowed(),
                    USUAL_URGENCY_FROM,
                    USUAL_URGENCY_TO));
  }

  public Stakes allowed(Duration time) {
    return new Stakes(benefit, chance, Optional.of(time), urgencyFrom, urgencyTo);
  }
}
