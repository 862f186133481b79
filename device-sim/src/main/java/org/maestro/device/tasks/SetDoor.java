package org.maestro.device.tasks;

import org.maestro.hal.DoorDrive;
import org.maestro.rats.member.Execution;

/** Opens or closes a door. */
final class SetDoor extends DeviceProcedure {

  private static final double SECONDS = 3;

  private final DoorDrive door;
  private final boolean open;

  SetDoor(FeatureContext context, boolean open) {
    this.door = context.driver(DoorDrive.class);
    this.open = open;
  }

  @Override
  void start(Execution execution, CallParameters parameters) {
    door.setOpen(open, ending(execution));
  }

  @Override
  Estimate cost(CallParameters parameters) {
    return price(door.isOpen() == open ? 0 : SECONDS, 0);
  }
}
