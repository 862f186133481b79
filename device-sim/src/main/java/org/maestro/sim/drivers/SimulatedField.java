package org.maestro.sim.drivers;

import org.maestro.hal.SignalField;
import org.maestro.sim.parameters.SignalData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.SignalMap;

/**
 * A service that knows the signal everywhere, and where each robot truly is: a reading is that of
 * the place at which the robot is when it is there, in whole numbers, rounded down.
 */
final class SimulatedField implements SignalField {

  private final Actuator actuator;
  private final SignalMap map;
  private final SignalData data;

  SimulatedField(Actuator actuator, SignalData data) {
    this.actuator = actuator;
    this.map = actuator.world().signal();
    this.data = data;
  }

  @Override
  public double seconds() {
    return data.readSeconds();
  }

  @Override
  public void read(String robot, Listener listener) {
    actuator.command(
        WorldEvent.Kind.READ,
        data.readSeconds(),
        listener::failed,
        () ->
            actuator
                .world()
                .position(robot)
                .ifPresentOrElse(
                    place -> listener.measured(Math.floor(map.strength(place.floor()))),
                    () -> listener.failed("nobody knows where " + robot + " is")));
  }
}
