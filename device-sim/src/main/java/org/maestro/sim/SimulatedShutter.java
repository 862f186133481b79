package org.maestro.sim;

import org.maestro.hal.Completion;
import org.maestro.hal.ShutterDrive;

/** A shutter's motor. */
final class SimulatedShutter implements ShutterDrive {

  private final Actuator actuator;
  private final PhysicalParameters.DriveData data;

  SimulatedShutter(Actuator actuator, PhysicalParameters.DriveData data) {
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
          actuator.world().setOpening(actuator.device(), newOpening);
          completion.done();
        });
  }

  @Override
  public double opening() {
    return actuator.world().opening(actuator.device());
  }
}
