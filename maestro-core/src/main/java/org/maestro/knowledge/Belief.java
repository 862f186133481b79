package org.maestro.knowledge;

import java.time.Instant;

/**
 * A current fact with its origin.
 *
 * @param fact in MAESTRO-SL: {@code (in Cup zone-b)}, {@code (not (in Bob zone-b))}, {@code (=
 *     (illuminance zone-b) 17)}
 * @param since by time of receipt
 */
public record Belief(String fact, Source source, Instant since) {}
