package org.maestro.console.access;

import java.time.Duration;
import java.util.Optional;

/** Says why somebody is not let in, in one sentence. */
public final class DeniedException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  private final Reason reason;
  private final transient Optional<Duration> again;

  /** What keeps somebody out. */
  public enum Reason {
    /** It is not known who asks. */
    UNKNOWN,

    /** It is known, and she may not. */
    FORBIDDEN,

    /** It was asked too often. */
    TOO_OFTEN
  }

  DeniedException(Reason reason, String sentence) {
    super(sentence);
    this.reason = reason;
    this.again = Optional.empty();
  }

  private DeniedException(Duration again) {
    super(
        "This was asked too often; it is answered again in %d s."
            .formatted(Math.max(1, again.toSeconds())));
    this.reason = Reason.TOO_OFTEN;
    this.again = Optional.of(again);
  }

  static DeniedException until(Duration again) {
    return new DeniedException(again);
  }

  public Reason reason() {
    return reason;
  }

  /** After which time it may be asked again, where that would help. */
  public Optional<Duration> again() {
    return again;
  }
}
