package org.maestro.sim.parameters;

/**
 * The times that doors, shutters and switches take.
 *
 * @param doorSeconds to open or close; assumed
 * @param shutterSeconds for the whole way; assumed
 * @param relaySeconds until a switch has switched, over its radio; assumed
 */
public record DriveData(double doorSeconds, double shutterSeconds, double relaySeconds) {
  static final DriveData USUAL = new DriveData(3, 8, 0.1);
}
