package org.maestro.rats.transport;

import java.time.Duration;
import java.util.Optional;

/**
 * A message to publish. The payload must not be changed afterwards.
 *
 * @param retained kept by the broker for later subscribers; with an empty payload it clears what is
 *     kept
 * @param expiry wall time (in process: the clock's); sent as whole seconds, rounded up
 */
public record Publication(
    String topic, byte[] payload, Quality quality, boolean retained, Optional<Duration> expiry) {

  /** MQTT's quality of service 0 and 1. */
  public enum Quality {
    AT_MOST_ONCE,
    AT_LEAST_ONCE
  }

  public static Publication retained(String topic, byte[] payload) {
    return new Publication(topic, payload, Quality.AT_LEAST_ONCE, true, Optional.empty());
  }

  public static Publication reliable(String topic, byte[] payload, Optional<Duration> expiry) {
    return new Publication(topic, payload, Quality.AT_LEAST_ONCE, false, expiry);
  }

  public static Publication stream(String topic, byte[] payload) {
    return new Publication(topic, payload, Quality.AT_MOST_ONCE, false, Optional.empty());
  }

  /** Ends the retention of a topic. */
  public static Publication clearing(String topic) {
    return retained(topic, new byte[0]);
  }
}
