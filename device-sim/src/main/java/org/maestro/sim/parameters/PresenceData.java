package org.maestro.sim.parameters;

/**
 * A radar that notices persons, moving or at rest, as such sensors for ceilings and walls do.
 *
 * @param everySeconds how often it looks; assumed
 * @param leastRadius of a body that it takes for a person; metres, assumed
 */
public record PresenceData(double everySeconds, double leastRadius) {
  static final PresenceData USUAL = new PresenceData(1, 0.15);

  public PresenceData {
    PhysicalParameters.positive("presence.everySeconds", everySeconds);
  }
}
