package org.maestro.planning.ground;

/** A task is of a kind that cannot be solved; the message says which part, and why. */
public final class GroundingException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  GroundingException(String sentence) {
    super(sentence);
  }

  /** The same, with where it is written. */
  GroundingException at(String place) {
    return new GroundingException(place + ": " + getMessage());
  }
}
