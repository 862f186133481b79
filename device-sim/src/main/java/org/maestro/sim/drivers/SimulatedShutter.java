package org.maestro.sim.drivers;

import org.maestro.hal.Completion;
import org.maestro.hal.ShutterDrive;
import org.maestro.sim.parameters.DriveData;
import org.maestro.sim.scene.WorldEvent;

/** A shutter's motor. */
final class SimulatedShutter implements ShutterDrive {

  private final Actuator actuator;
  private final DriveData data;

  SimulatedShutter(Actuator actuator, DriveData data) {
    this.actuator = actuator;
    this.data = data;
  }

  @Override
  public void setOpening(double newOpening, Completion completion) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        Math.abs(newOpening - opening()) * data.shutterSeconds(),
        completion::failed,
        () -> {
          actuator.world().lighting().setOpening(actuator.device(), newOpening);
          completion.done();
        });
  }

  @Override
  public double opening() {
    return actuator.world().opening(actuator.device());
  }
}
