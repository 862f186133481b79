package org.maestro.console.history;

import java.time.Instant;

/** From one moment to another. */
record Span(Instant from, Instant to) {}
