package org.maestro.sim.parameters;

import org.maestro.sim.scene.SimulationException;

/**
 * What the warmth of rooms follows from. Each zone is one heat capacity that loses heat outdoors
 * and is heated or not; neither sun nor people nor other zones warm it, and it is as warm outdoors
 * all day, which is assumed.
 */
public record ClimateData(
    @Quantity(
            meaning = "how warm it is outdoors unless the scene says so",
            unit = "°C",
            source = "assumed: a mild winter's day")
        double outsideCelsius,
    @Quantity(
            meaning = "how warm a zone is in the beginning unless the scene says so",
            unit = "°C",
            source = "assumed")
        double insideCelsius,
    @Quantity(
            meaning = "heat that a square metre of floor stores",
            unit = "Wh/(m² K)",
            source = "ISO 13790, table 12: 165 kJ/K for a building of medium weight")
        double capacity,
    @Quantity(
            meaning = "heat that a square metre of floor loses outdoors",
            unit = "W/(m² K)",
            source = "assumed")
        double loss,
    @Quantity(
            meaning = "what a heating that is on gives each square metre",
            unit = "W/m²",
            source = "assumed")
        double heating,
    @Quantity(
            meaning = "a thermostat heats from so much below its target to so much above it",
            unit = "K",
            source = "assumed")
        double hysteresis) {
  static final ClimateData USUAL = new ClimateData(5, 20, 46, 1.5, 100, 0.25);

  private static final double SECONDS_PER_HOUR = 3600;

  /**
   * @throws SimulationException when a number makes no sense
   */
  public ClimateData {
    PhysicalParameters.positive("climate.capacity", capacity);
    PhysicalParameters.positive("climate.loss", loss);
    PhysicalParameters.positive("climate.heating", heating);
    PhysicalParameters.positive("climate.hysteresis", hysteresis);
  }

  /** After which all but 1/e of a difference to outdoors is lost; seconds. */
  public double lagSeconds() {
    return capacity / loss * SECONDS_PER_HOUR;
  }

  /** By how much a zone becomes warmer than outdoors when it is heated for ever; kelvins. */
  public double mostAboveOutside() {
    return heating / loss;
  }
}
