package org.maestro.device.tasks;

/**
 * A call's parameters are not what the procedure needs; the message says which and what would be
 * right.
 */
final class InvalidCallException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  InvalidCallException(String message) {
    super(message);
  }
}
