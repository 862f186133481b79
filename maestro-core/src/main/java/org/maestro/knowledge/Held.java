package org.maestro.knowledge;

import java.time.Instant;
import org.maestro.sl.Term;

/**
 * A value with its origin.
 *
 * @param value of a number, of a functional predicate, or a truth value
 * @param since by time of receipt
 * @param fromPosition it follows from where things were seen, and goes when the position goes
 * @param serial names the observation in the dataset
 */
record Held(Term value, Source source, Instant since, boolean fromPosition, long serial) {}
