package org.maestro.sim.drivers;

import org.maestro.hal.Battery;
import org.maestro.hal.Completion;
import org.maestro.sim.parameters.BatteryData;
import org.maestro.sim.scene.WorldEvent;

/**
 * A robot's battery with its gauge. When it is empty the robot has no power: it stands still, lets
 * go of what it holds and leaves the bus. At a station it is filled evenly.
 */
final class SimulatedBattery implements Battery {

  /** So near to full it is full. */
  private static final double FULL_SECONDS = 0.001;

  private final Actuator actuator;
  private final BatteryData data;
  private double told;
  private long fillNumber;

  private SimulatedBattery(Actuator actuator, BatteryData data) {
    this.actuator = actuator;
    this.data = data;
    this.told = gauged();
  }

  /** From now on it is looked at from time to time. */
  static SimulatedBattery start(Actuator actuator, BatteryData data) {
    SimulatedBattery battery = new SimulatedBattery(actuator, data);
    battery.lookLater();
    return battery;
  }

  private void lookLater() {
    actuator.afterInAnyCase(data.checkSeconds(), this::look);
  }

  private void look() {
    boolean alive = actuator.world().isAlive(actuator.device());
    if (alive) {
      tellWhatIsLeft();
    }
    if (alive && left() <= 0) {
      actuator.tell(WorldEvent.Kind.EMPTIED);
      actuator.world().die(actuator.device());
    }
    lookLater();
  }

  private void tellWhatIsLeft() {
    double gauged = gauged();
    if (gauged != told) {
      told = gauged;
      actuator.tell(WorldEvent.Kind.DRAINED);
    }
  }

  private double left() {
    return actuator.world().charge(actuator.device());
  }

  /** In whole steps, rounded up, so that 0 is told of an empty one only. */
  private double gauged() {
    double steps = Math.rint(1 / data.worthTelling());
    return Math.ceil(left() * steps - 1e-9) / steps;
  }

  @Override
  public double charge() {
    return told;
  }

  @Override
  public double secondsToFull() {
    return data.secondsToFill(1 - left());
  }

  @Override
  public void fill(Completion completion) {
    long number = ++fillNumber;
    actuator.after(0, () -> plugIn(number, completion));
  }

  private void plugIn(long number, Completion completion) {
    if (number != fillNumber) {
      return;
    }
    if (!actuator.world().isAtStation(actuator.device())) {
      completion.failed("there is no charging station here");
      return;
    }
    actuator.world().batteries().plug(actuator.device(), data.chargingWatts());
    goOn(number, completion);
  }

  private void goOn(long number, Completion completion) {
    if (number != fillNumber) {
      return;
    }
    double seconds = secondsToFull();
    if (seconds > FULL_SECONDS) {
      actuator.after(Math.min(seconds, data.checkSeconds()), () -> goOn(number, completion));
    } else {
      stopFilling();
      tellWhatIsLeft();
      completion.done();
    }
  }

  @Override
  public void stopFilling() {
    fillNumber++;
    actuator.world().batteries().plug(actuator.device(), 0);
  }
}
