package org.maestro.hal;

/** A sensor of how warm the air of the zone is in which it stands. It tells what it told last. */
public interface Thermometer {

  /** Degrees Celsius. */
  double celsius();
}
