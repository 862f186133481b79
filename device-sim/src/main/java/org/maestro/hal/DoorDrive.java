package org.maestro.hal;

/** A motor that opens and closes a door. */
public interface DoorDrive {

  void setOpen(boolean open, Completion completion);

  boolean isOpen();
}
