package org.maestro.sim;

import java.util.List;
import org.maestro.hal.DaylightSensor;
import org.maestro.ontology.home.Glass;

/**
 * A sensor of the light upon the outside of windows, the mean of them. It measures by itself and
 * tells what differs from what it told last.
 */
final class SimulatedDaylightSensor implements DaylightSensor {

  private final Actuator actuator;
  private final PhysicalParameters.FacadeData data;
  private final List<Glass> windows;
  private double told;

  private SimulatedDaylightSensor(
      Actuator actuator, PhysicalParameters.FacadeData data, List<Glass> windows) {
    this.actuator = actuator;
    this.data = data;
    this.windows = windows;
  }

  /** It measures from now on. */
  static SimulatedDaylightSensor start(
      Actuator actuator, PhysicalParameters.FacadeData data, List<Glass> windows) {
    SimulatedDaylightSensor sensor = new SimulatedDaylightSensor(actuator, data, windows);
    sensor.told = sensor.measured();
    sensor.goOn();
    return sensor;
  }

  private void goOn() {
    actuator.afterInAnyCase(data.everySeconds(), this::measure);
  }

  private void measure() {
    if (actuator.world().isAlive(actuator.device())) {
      double lux = measured();
      if (Math.abs(lux - told) > data.worthTelling() * told) {
        told = lux;
        actuator.tell(WorldEvent.Kind.MEASURED);
      }
    }
    goOn();
  }

  private double measured() {
    double mean =
        windows.stream().mapToDouble(glass -> actuator.world().luxUpon(glass)).average().orElse(0);
    return Math.round(Math.max(0, mean * (1 + actuator.error(data.noise()))));
  }

  @Override
  public double lux() {
    return told;
  }
}
