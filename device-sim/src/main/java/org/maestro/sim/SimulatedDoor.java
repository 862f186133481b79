package org.maestro.sim;

import org.maestro.hal.Completion;
import org.maestro.hal.DoorDrive;

/** A driven door; it passes from one state to the other at the end of its movement. */
final class SimulatedDoor implements DoorDrive {

  private final Actuator actuator;
  private final DriveData data;

  SimulatedDoor(Actuator actuator, DriveData data) {
    this.actuator = actuator;
    this.data = data;
  }

  @Override
  public void setOpen(boolean open, Completion completion) {
    actuator.command(
        WorldEvent.Kind.ADJUST,
        isOpen() == open ? 0 : data.doorSeconds(),
        completion::failed,
        () -> {
          actuator.world().setDoor(actuator.device(), open);
          completion.done();
        });
  }

  @Override
  public boolean isOpen() {
    return actuator.world().isOpen(actuator.device());
  }
}
