package org.maestro.sim.parameters;

/** A radar that notices persons, moving or at rest, as such sensors for ceilings and walls do. */
public record PresenceData(
    @Quantity(meaning = "time between two looks", unit = "s", source = "assumed")
        double everySeconds,
    @Quantity(
            meaning = "radius of a body that it takes for a person",
            unit = "m",
            source = "assumed")
        double leastRadius,
    @Quantity(
            meaning = "how often it does not notice who is there, 0 to 1",
            unit = "1",
            source = "assumed: never")
        double missShare,
    @Quantity(
            meaning = "how often it notices nobody as somebody, 0 to 1",
            unit = "1",
            source = "assumed: never")
        double falseShare,
    @Quantity(meaning = "how long such an error lasts", unit = "s", source = "assumed")
        double errorSeconds) {
  static final PresenceData USUAL = new PresenceData(1, 0.15, 0, 0, 10);

  public PresenceData {
    PhysicalParameters.positive("presence.everySeconds", everySeconds);
    PhysicalParameters.positive("presence.errorSeconds", errorSeconds);
    PhysicalParameters.share("presence.missShare", missShare);
    PhysicalParameters.share("presence.falseShare", falseShare);
  }
}
