package org.maestro.sim.drivers;

import java.time.Duration;
import org.maestro.hal.Thermometer;
import org.maestro.sim.parameters.ThermometerData;
import org.maestro.sim.scene.WorldEvent;

/**
 * A sensor of the air's warmth in a zone, with noise and in steps: it measures by itself, and tells
 * what differs much from what it told last, and now and then what differs at all.
 */
final class SimulatedThermometer implements Thermometer {

  private final Actuator actuator;
  private final ThermometerData data;
  private final String zone;
  private double told;
  private Duration toldAt;

  private SimulatedThermometer(Actuator actuator, ThermometerData data, String zone) {
    this.actuator = actuator;
    this.data = data;
    this.zone = zone;
    this.told = measured();
    this.toldAt = actuator.clock().now();
  }

  /** It measures from now on. */
  static SimulatedThermometer start(Actuator actuator, ThermometerData data, String zone) {
    SimulatedThermometer thermometer = new SimulatedThermometer(actuator, data, zone);
    thermometer.goOn();
    return thermometer;
  }

  private void goOn() {
    actuator.afterInAnyCase(data.everySeconds(), this::measure);
  }

  private void measure() {
    double now = measured();
    if (actuator.world().isAlive(actuator.device()) && isWorthTelling(now)) {
      told = now;
      toldAt = actuator.clock().now();
      actuator.tell(WorldEvent.Kind.MEASURED);
    }
    goOn();
  }

  private boolean isWorthTelling(double now) {
    boolean isDue =
        actuator.clock().now().minus(toldAt).toMillis() / 1e3 >= data.tellEverySeconds();
    return Math.abs(now - told) >= data.worthTelling() || (isDue && now != told);
  }

  private double measured() {
    double truth = actuator.world().celsius(zone);
    double shown = actuator.world().faults().shown(actuator.device(), truth);
    double steps = 1 / data.resolution();
    return Math.round((shown + actuator.error(data.noise())) * steps) / steps;
  }

  @Override
  public double celsius() {
    return told;
  }
}
