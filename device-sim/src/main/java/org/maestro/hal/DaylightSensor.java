package org.maestro.hal;

/**
 * A sensor of the light upon the outside of windows, as shutters come with. It tells what was worth
 * telling last.
 */
public interface DaylightSensor {

  /** Light that falls upon them from all sides, from sky and ground; lux. */
  double diffuseLux();

  /** Light that falls upon them straight from the sun; lux. */
  double sunLux();
}
