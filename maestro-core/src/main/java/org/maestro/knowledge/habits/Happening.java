package org.maestro.knowledge.habits;

import java.time.Instant;
import org.maestro.sl.Expression;

/**
 * Something that has become so once, and is counted.
 *
 * @param counted the number that it adds to
 */
record Happening(Instant at, Expression.Fluent counted) {}
