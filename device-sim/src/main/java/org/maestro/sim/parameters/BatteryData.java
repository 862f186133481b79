package org.maestro.sim.parameters;

import org.maestro.sim.scene.SimulationException;

/**
 * The capacity of a robot's battery, and what draws from it beside base and arm while they move.
 */
public record BatteryData(
    @Quantity(
            meaning = "energy of a full battery",
            unit = "Wh",
            source = "KUKA youBot data sheet: 24 V, 5 Ah")
        double wattHours,
    @Quantity(meaning = "power of computer, scanner and camera", unit = "W", source = "assumed")
        double idleWatts,
    @Quantity(
            meaning = "power that a station gives",
            unit = "W",
            source = "assumed from 24 V and 8 A")
        double chargingWatts,
    @Quantity(
            meaning = "share of the charge after which it is told anew",
            unit = "1",
            source = "assumed")
        double worthTelling,
    @Quantity(meaning = "how often it is looked at", unit = "s", source = "assumed")
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
