package org.maestro.knowledge;

import java.time.Instant;
import org.maestro.sl.Term;

/**
 * A value with its origin.
 *
 * @param value of a number, of a functional predicate, or a truth value
 * @param since by time of receipt
 * @param expires the last instant at which it counts; {@link Instant#MAX} when it does not age
 * @param confidence of the source in it, 0 to 1
 * @param fromPosition it follows from where things were seen, and goes when the position goes
 * @param serial names the observation in the dataset
 */
record Held(
    Term value,
    Source source,
    Instant since,
    Instant expires,
    double confidence,
    boolean fromPosition,
    long serial) {

  boolean isExpected() {
    return source.kind() == Source.Kind.EXPECTED;
  }

  boolean isNumber() {
    return value instanceof Term.Number;
  }

  boolean isFresh(Instant now) {
    return !expires.isBefore(now);
  }
}
