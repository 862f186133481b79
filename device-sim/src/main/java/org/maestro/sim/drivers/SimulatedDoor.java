package org.maestro.sim.drivers;

import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.maestro.hal.Completion;
import org.maestro.hal.DoorDrive;
import org.maestro.sim.parameters.DriveData;
import org.maestro.sim.scene.WorldEvent;

/** A driven door; it passes from one state to the other at the end of its movement. */
final class SimulatedDoor implements DoorDrive {

  private final Actuator actuator;
  private final DriveData data;
  private final BooleanSupplier locked;
  private Optional<Boolean> order = Optional.empty();

  SimulatedDoor(Actuator actuator, DriveData data, BooleanSupplier locked) {
    this.actuator = actuator;
    this.data = data;
    this.locked = locked;
  }

  @Override
  public void setOpen(boolean open, Completion completion) {
    if (locked.getAsBoolean() && open && !isOpen()) {
      completion.failed("it is locked");
      return;
    }
    actuator.command(
        WorldEvent.Kind.ADJUST,
        isOpen() == open ? 0 : data.doorSeconds(),
        completion::failed,
        () -> {
          if (!actuator.flaw().isIdle()) {
            actuator.world().setDoor(actuator.device(), open);
          }
          order = Optional.of(open);
          completion.done();
        });
  }

  @Override
  public boolean isOpen() {
    return order
        .filter(told -> actuator.flaw().repeatsOrders())
        .orElseGet(() -> actuator.world().isOpen(actuator.device()));
  }
}
