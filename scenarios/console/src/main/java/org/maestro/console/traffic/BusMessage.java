package org.maestro.console.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.Optional;

/**
 * A message of the bus, as it was heard.
 *
 * @param payload as much of it as anybody on the bus would read; not to be changed
 * @param bytes of the payload as it was
 * @param problem what was found when it came; of most it is found when they are looked at
 * @param at wall time
 * @param since simulated time since the platform's clock began
 */
record BusMessage(
    String topic,
    byte[] payload,
    int bytes,
    boolean retained,
    Optional<String> problem,
    Instant at,
    Duration since) {}
