package org.maestro.sim.drivers;

import org.maestro.hal.Transmitter;
import org.maestro.sim.parameters.SignalData;
import org.maestro.sim.scene.WorldEvent;
import org.maestro.sim.world.SignalMap;

/** A robot's radio: it sends when the signal is strong enough where the robot truly is. */
final class SimulatedTransmitter implements Transmitter {

  private final Actuator actuator;
  private final SignalMap map;
  private final SignalData data;

  SimulatedTransmitter(Actuator actuator, SignalData data) {
    this.actuator = actuator;
    this.map = actuator.world().signal();
    this.data = data;
  }

  @Override
  public double neededStrength() {
    return data.needed();
  }

  @Override
  public double seconds() {
    return data.transmitSeconds();
  }

  /** It is felt at once whether there is a link; sending takes its time. */
  @Override
  public void transmit(Listener listener) {
    double strength = strength();
    if (strength < data.needed()) {
      actuator.after(0, () -> listener.tooWeak(Math.floor(strength)));
      return;
    }
    actuator.command(
        WorldEvent.Kind.TRANSMIT,
        data.transmitSeconds(),
        listener::failed,
        () -> {
          actuator.tell(WorldEvent.Kind.TRANSMITTED);
          listener.sent();
        });
  }

  private double strength() {
    return map.strength(actuator.world().position(actuator.device()).orElseThrow().floor());
  }
}
