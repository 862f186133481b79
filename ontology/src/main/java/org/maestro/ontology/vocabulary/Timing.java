package org.maestro.ontology.vocabulary;

import java.time.Duration;
import java.util.Optional;
import org.maestro.sl.Formula;

/**
 * How long a feature's call may take, what has to hold meanwhile, and when its effect is there.
 *
 * @param limit how long a call may take; absent: thrice the expected duration
 * @param grace how long beyond that the member may take to end it and to answer; absent: some
 *     seconds
 * @param meanwhile a part of the precondition that has to hold from the call to the answer; absent:
 *     none
 * @param doneWhen the effect is there when this is known to hold, which the member tells of itself;
 *     absent: with the answer
 * @param effectAfter the effect is there so long after the answer; absent: with it
 */
public record Timing(
    Optional<Duration> limit,
    Optional<Duration> grace,
    Optional<Formula> meanwhile,
    Optional<Formula> doneWhen,
    Optional<Duration> effectAfter) {

  /** The answer comes within thrice the expected duration, and the effect is there then. */
  public static final Timing USUAL =
      new Timing(
          Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty(), Optional.empty());

  /** What differs from the other. */
  Timing or(Timing other) {
    return new Timing(
        limit.or(other::limit),
        grace.or(other::grace),
        meanwhile.or(other::meanwhile),
        doneWhen.or(other::doneWhen),
        effectAfter.or(other::effectAfter));
  }
}
