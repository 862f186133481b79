package org.maestro.sim.drivers;

import java.util.List;
import org.maestro.hal.DaylightSensor;
import org.maestro.ontology.floor.Glass;
import org.maestro.sim.parameters.FacadeData;
import org.maestro.sim.scene.WorldEvent;

/**
 * A sensor of the light upon the outside of windows, the mean of them. It measures by itself and
 * tells what differs from what it told last.
 */
final class SimulatedDaylightSensor implements DaylightSensor {

  private final Actuator actuator;
  private final FacadeData data;
  private final List<Glass> windows;
  private Reading told = new Reading(0, 0);

  private record Reading(double diffuse, double sun) {}

  private SimulatedDaylightSensor(Actuator actuator, FacadeData data, List<Glass> windows) {
    this.actuator = actuator;
    this.data = data;
    this.windows = windows;
  }

  /** It measures from now on. */
  static SimulatedDaylightSensor start(Actuator actuator, FacadeData data, List<Glass> windows) {
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
      Reading now = measured();
      if (isWorthTelling(now)) {
        told = now;
        actuator.tell(WorldEvent.Kind.MEASURED);
      }
    }
    goOn();
  }

  /**
   * Each by itself: the first sun is little beside a bright sky, and blinds others all the same.
   */
  private boolean isWorthTelling(Reading now) {
    return differs(now.diffuse(), told.diffuse()) || differs(now.sun(), told.sun());
  }

  private boolean differs(double now, double before) {
    return Math.abs(now - before) > data.worthTelling() * before;
  }

  private Reading measured() {
    double sun =
        windows.stream()
            .mapToDouble(glass -> actuator.world().lighting().sunUpon(glass))
            .average()
            .orElse(0);
    return new Reading(noisy(actuator.world().lighting().diffuseUponWindows()), noisy(sun));
  }

  private double noisy(double lux) {
    return Math.round(Math.max(0, lux * (1 + actuator.error(data.noise()))));
  }

  @Override
  public double diffuseLux() {
    return told.diffuse();
  }

  @Override
  public double sunLux() {
    return told.sun();
  }
}
