package org.maestro.hal;

/** A sensor of the light upon the outside of a window, such as shutters come with. */
public interface DaylightSensor {

  /** What it measured last that was worth telling; lux. */
  double lux();
}
