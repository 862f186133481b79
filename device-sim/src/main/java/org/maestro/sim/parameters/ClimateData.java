package org.maestro.sim.parameters;

import org.maestro.sim.scene.SimulationException;

/**
 * What the warmth of rooms follows from. Each zone is one heat capacity that loses heat outdoors
 * and is heated or not; neither sun nor people nor other zones warm it, and it is as warm outdoors
 * all day, which is assumed.
 *
 * @param outsideCelsius how warm it is outdoors unless the scene says so; assumed, a mild winter's
 *     day
 * @param insideCelsius how warm a zone is in the beginning unless the scene says so; assumed
 * @param capacity heat that a square metre of floor stores; watt-hours per kelvin. ISO 13790, table
 *     12: 165 kJ/K for a building of medium weight
 * @param loss heat that a square metre of floor loses outdoors; watts per kelvin, assumed
 * @param heating what a heating that is on gives each square metre; watts, assumed
 * @param hysteresis a thermostat heats from so many kelvins below its target to so many above it;
 *     assumed
 */
public record ClimateData(
    double outsideCelsius,
    double insideCelsius,
    double capacity,
    double loss,
    double heating,
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
