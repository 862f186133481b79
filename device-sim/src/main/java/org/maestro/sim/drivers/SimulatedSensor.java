package org.maestro.sim.drivers;

import java.util.function.Supplier;
import org.maestro.hal.IlluminationSensor;
import org.maestro.hal.Position;
import org.maestro.sim.parameters.SensorData;
import org.maestro.sim.scene.WorldEvent;

/**
 * An illumination sensor: the light at its place, with noise, in steps and within its range. One on
 * board of a robot is where the robot is.
 */
final class SimulatedSensor implements IlluminationSensor {

  private final Actuator actuator;
  private final SensorData data;
  private final Supplier<Position> place;

  SimulatedSensor(Actuator actuator, SensorData data, Supplier<Position> place) {
    this.actuator = actuator;
    this.data = data;
    this.place = place;
  }

  @Override
  public void read(Listener listener) {
    actuator.command(
        WorldEvent.Kind.READ,
        data.integrationSeconds(),
        listener::failed,
        () ->
            listener.measured(
                reading(
                    actuator
                            .world()
                            .faults()
                            .shown(actuator.device(), actuator.world().lux(place.get()))
                        * (1 + actuator.error(data.noise())))));
  }

  private double reading(double lux) {
    double steps = 1 / data.leastLux();
    double inSteps = Math.round(lux * steps) / steps;
    return Math.max(data.leastLux(), Math.min(data.greatestLux(), inSteps));
  }
}
