package org.maestro.platform.jade;

/**
 * The platform, or a join to it, could not start. The message is one sentence: what, where, what to
 * do.
 */
public sealed class PlatformStartException extends RuntimeException permits NameTakenException {
  private static final long serialVersionUID = 1L;

  public PlatformStartException(String message) {
    super(message);
  }

  public PlatformStartException(String message, Throwable cause) {
    super(message, cause);
  }
}
