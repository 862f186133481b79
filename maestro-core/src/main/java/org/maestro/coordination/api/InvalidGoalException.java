package org.maestro.coordination.api;

/**
 * The goal cannot be meant: it names what nobody knows. The message is one sentence that says what,
 * and what to do.
 */
public final class InvalidGoalException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public InvalidGoalException(String message) {
    super(message);
  }
}
