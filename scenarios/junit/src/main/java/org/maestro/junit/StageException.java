package org.maestro.junit;

/**
 * A stage cannot be set, or what was awaited on it did not come. The message says what, where, and
 * what to do.
 */
public final class StageException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  StageException(String message) {
    super(message);
  }

  StageException(String message, Throwable cause) {
    super(message, cause);
  }
}
