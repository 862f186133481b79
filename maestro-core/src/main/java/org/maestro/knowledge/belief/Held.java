package org.maestro.knowledge.belief;

import java.time.Duration;
import java.time.Instant;
import java.util.OptionalDouble;
import org.maestro.knowledge.api.Source;
import org.maestro.sl.Term;

/**
 * A value with its origin.
 *
 * @param value of a number, of a functional predicate, or a truth value
 * @param since by time of receipt
 * @param expires the last instant at which it counts; {@link Instant#MAX} when it does not age
 * @param noted when what it says was written down; what is repeated soon after is not written anew
 * @param confidence of the source in it, 0 to 1
 * @param fromPosition it follows from where things were seen, and goes when the position goes
 * @param coveredShare the share of a place's floor, 0 to 1, of which the source speaks, where it
 *     said so
 * @param serial names the observation in the dataset
 */
public record Held(
    Term value,
    Source source,
    Instant since,
    Instant expires,
    Instant noted,
    double confidence,
    boolean fromPosition,
    OptionalDouble coveredShare,
    long serial) {

  private static final int TENTH = 10;
  private static final Duration LASTING = Duration.ofMinutes(1);

  boolean isExpected() {
    return source.kind() == Source.Kind.EXPECTED;
  }

  boolean isNumber() {
    return value instanceof Term.Number;
  }

  boolean isFresh(Instant now) {
    return !expires.isBefore(now);
  }

  /**
   * Whether the same, said again then, need not be written down again: what is written may be older
   * than what is known by a tenth of its validity.
   */
  boolean isRepeatedBy(Instant then, Instant untilThen) {
    Duration tolerance =
        untilThen.equals(Instant.MAX)
            ? LASTING
            : Duration.between(then, untilThen).dividedBy(TENTH);
    return !noted.plus(tolerance).isBefore(then);
  }
}
