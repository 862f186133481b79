package org.maestro.sim;

import org.maestro.hal.Battery;

/**
 * A robot's battery with its gauge. When it is empty the robot has no power: it stands still, lets
 * go of what it holds and leaves the bus.
 */
final class SimulatedBattery implements Battery {

  private final Actuator actuator;
  private final PhysicalParameters.BatteryData data;
  private double told;

  private SimulatedBattery(Actuator actuator, PhysicalParameters.BatteryData data) {
    this.actuator = actuator;
    this.data = data;
    this.told = gauged();
  }

  /** From now on it is looked at from time to time. */
  static SimulatedBattery start(Actuator actuator, PhysicalParameters.BatteryData data) {
    SimulatedBattery battery = new SimulatedBattery(actuator, data);
    battery.lookLater();
    return battery;
  }

  private void lookLater() {
    actuator.afterInAnyCase(data.checkSeconds(), this::look);
  }

  private void look() {
    double gauged = gauged();
    boolean alive = actuator.world().isAlive(actuator.device());
    if (alive && gauged != told) {
      told = gauged;
      actuator.tell(WorldEvent.Kind.DRAINED);
    }
    if (alive && actuator.world().charge(actuator.device()) <= 0) {
      actuator.tell(WorldEvent.Kind.EMPTIED);
      actuator.world().die(actuator.device());
    }
    lookLater();
  }

  /** In whole steps, rounded up, so that 0 is told of an empty one only. */
  private double gauged() {
    double steps = Math.rint(1 / data.worthTelling());
    return Math.ceil(actuator.world().charge(actuator.device()) * steps - 1e-9) / steps;
  }

  @Override
  public double charge() {
    return told;
  }
}
