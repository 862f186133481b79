package org.maestro.knowledge.api;

import java.time.Duration;
import java.time.Instant;
import java.util.OptionalDouble;

/**
 * A fact with its origin.
 *
 * @param fact in MAESTRO-SL: {@code (in Cup zone-b)}, {@code (not (in Bob zone-b))}, {@code (=
 *     (illuminance zone-b) 17)}
 * @param since by time of receipt
 * @param confidence of the source in it, 0 to 1
 * @param coveredShare of a fact that says where something is not: the share of that place's floor,
 *     0 to 1, that the source looked at, where it is known
 */
public record Belief(
    String fact, Source source, Instant since, double confidence, OptionalDouble coveredShare) {

  /** A fact of which no covered area is known. */
  public Belief(String fact, Source source, Instant since, double confidence) {
    this(fact, source, since, confidence, OptionalDouble.empty());
  }

  /** A fact of whose source there is no doubt. */
  public Belief(String fact, Source source, Instant since) {
    this(fact, source, since, 1);
  }

  public Duration age(Instant now) {
    return Duration.between(since, now);
  }
}
