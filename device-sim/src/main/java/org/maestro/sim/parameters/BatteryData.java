package org.maestro.sim.parameters;

import org.maestro.sim.scene.SimulationException;

/**
 * The capacity of a robot's battery, and what draws from it beside base and arm while they move.
 *
 * @param wattHours KUKA youBot data sheet: 24 V, 5 Ah
 * @param idleWatts of computer, scanner and camera; assumed
 * @param chargingWatts that a station gives; assumed from 24 V and 8 A
 * @param worthTelling share of the charge after which it is told anew; assumed
 * @param checkSeconds how often it is looked at; assumed
 */
public record BatteryData(
    double wattHours,
    double idleWatts,
    double chargingWatts,
    double worthTelling,
    double checkSeconds) {
  static final BatteryData YOUBOT = new BatteryData(120, 20, 192, 0.05, 5);
  private static final double SECONDS_PER_HOUR = 3600;

  public BatteryData {
    PhysicalParameters.positive("battery.wattHours", wattHours);
    PhysicalParameters.positive("battery.chargingWatts above idleWatts", chargingWatts - idleWatts);
    PhysicalParameters.positive("battery.worthTelling", worthTelling);
    if (worthTelling > 1) {
      throw new SimulationException("The setting world.battery.worthTelling is 1 at most.");
    }
    PhysicalParameters.positive("battery.checkSeconds", checkSeconds);
  }

  /** At a station, while it idles. */
  public double secondsToFill(double share) {
    return Math.max(0, share) * wattHours * SECONDS_PER_HOUR / (chargingWatts - idleWatts);
  }
}
