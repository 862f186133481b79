package org.maestro.rats.protocol;

import java.util.List;
import java.util.Optional;

/**
 * Why a call did not succeed, and what would help.
 *
 * @param refs the facts it depends on, in MAESTRO-SL
 */
public record RatsError(
    ErrorCode code,
    Level level,
    String message,
    Optional<String> hint,
    List<Reference> refs,
    boolean retriable) {
  public RatsError {
    refs = List.copyOf(refs);
  }

  public enum Level {
    INFO,
    WARNING,
    ERROR
  }

  /**
   * A fact that stands in the way.
   *
   * @param fact in MAESTRO-SL, {@code (illuminance zone-b)}
   * @param need such as {@code >= 72}
   * @param have a number, text or truth value
   */
  public record Reference(String fact, String need, Object have) {}
}
