package org.maestro.sim.scene;

/** A home or a scene cannot be simulated; the message says what, where and what to do. */
public final class SimulationException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public SimulationException(String message) {
    super(message);
  }

  public SimulationException(String message, Throwable cause) {
    super(message, cause);
  }
}
