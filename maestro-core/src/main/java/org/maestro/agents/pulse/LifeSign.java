package org.maestro.agents.pulse;

import java.time.Duration;

/**
 * The last sign of life of a container.
 *
 * @param silence wall time since then
 */
public record LifeSign(Condition condition, Duration silence) {}
