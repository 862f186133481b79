package org.maestro.deployment;

/** Something about agents and containers cannot be done; the message is one sentence. */
public final class DeploymentException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public DeploymentException(String message) {
    super(message);
  }
}
