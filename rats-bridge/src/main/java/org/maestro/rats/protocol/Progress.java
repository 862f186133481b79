package org.maestro.rats.protocol;

import java.util.Map;

/**
 * A sign of life of a running call.
 *
 * @param fraction done, 0 to 1
 * @param values first values of an established continuous feature, else empty
 */
public record Progress(
    String id, String from, Kind kind, double fraction, Map<String, Object> values) {

  public enum Kind {
    ACCEPTED,
    STARTED,
    ESTABLISHED,
    RUNNING
  }
}
