package org.maestro.device.tasks;

/** A device's description asks for what its drivers or this software cannot do. */
public final class DeviceSetupException extends RuntimeException {
  private static final long serialVersionUID = 1L;

  public DeviceSetupException(String message) {
    super(message);
  }
}
