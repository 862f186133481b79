package org.maestro.sim.parameters;

/**
 * A radar that notices persons, moving or at rest, as such sensors for ceilings and walls do.
 *
 * @param everySeconds how often it looks; assumed
 * @param leastRadius of a body that it takes for a person; metres, assumed
 * @param missShare how often it does not notice who is there, 0 to 1; assumed never
 * @param falseShare how often it notices nobody as somebody, 0 to 1; assumed never
 * @param errorSeconds how long such an error lasts; assumed
 */
public record PresenceData(
    double everySeconds,
    double leastRadius,
    double missShare,
    double falseShare,
    double errorSeconds) {
  static final PresenceData USUAL = new PresenceData(1, 0.15, 0, 0, 10);

  public PresenceData {
    PhysicalParameters.positive("presence.everySeconds", everySeconds);
    PhysicalParameters.positive("presence.errorSeconds", errorSeconds);
    PhysicalParameters.share("presence.missShare", missShare);
    PhysicalParameters.share("presence.falseShare", falseShare);
  }
}
