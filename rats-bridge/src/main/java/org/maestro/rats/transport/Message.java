package org.maestro.rats.transport;

import java.time.Duration;
import java.util.Optional;

/**
 * A message as it arrived. The payload must not be changed: it may be shared.
 *
 * @param retained the retain flag: the message was kept by the broker, or was published with the
 *     flag
 * @param remainingExpiry what is left of its expiry (wall time; in process: the clock's)
 */
public record Message(
    String topic, byte[] payload, boolean retained, Optional<Duration> remainingExpiry) {}
