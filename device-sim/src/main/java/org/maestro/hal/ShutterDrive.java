package org.maestro.hal;

/** A motor that moves a shutter. */
public interface ShutterDrive {

  /**
   * @param opening share of the window that is free, 0 to 1
   */
  void setOpening(double opening, Completion completion);

  double opening();
}
