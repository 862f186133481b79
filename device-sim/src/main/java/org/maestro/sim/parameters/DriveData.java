package org.maestro.sim.parameters;

/** The times that doors, shutters and switches take. */
public record DriveData(
    @Quantity(meaning = "time of a door to open or close", unit = "s", source = "assumed")
        double doorSeconds,
    @Quantity(meaning = "time of a shutter for its whole way", unit = "s", source = "assumed")
        double shutterSeconds,
    @Quantity(
            meaning = "time until a switch has switched, over its radio",
            unit = "s",
            source = "assumed")
        double relaySeconds) {
  static final DriveData USUAL = new DriveData(3, 8, 0.1);
}
