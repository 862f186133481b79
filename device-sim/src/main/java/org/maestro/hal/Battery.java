package org.maestro.hal;

/** A device's battery; it tells what was worth telling last. */
public interface Battery {

  /** What is left, 0 to 1. */
  double charge();
}
