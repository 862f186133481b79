package org.maestro.sim.drivers;

import org.maestro.hal.Completion;
import org.maestro.hal.Switch;
import org.maestro.sim.parameters.DriveData;
import org.maestro.sim.scene.WorldEvent;

/** A relay before a lamp. */
final class SimulatedSwitch implements Switch {

  private final Actuator actuator;
  private final DriveData data;

  SimulatedSwitch(Actuator actuator, DriveData data) {
    this.actuator = actuator;
    this.data = data;
  }

  @Override
  public void set(boolean on, Completion completion) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        data.relaySeconds(),
        completion::failed,
        () -> {
          actuator.world().lighting().setLevel(actuator.device(), on ? 1 : 0);
          actuator.tell(WorldEvent.Kind.LIT);
          completion.done();
        });
  }

  @Override
  public boolean isOn() {
    return actuator.world().lampLevel(actuator.device()) > 0;
  }
}
