package org.maestro.sim.parameters;

/**
 * The light sensor on the outside of a shutter's window: it tells what the sun sends straight from
 * what comes from all sides, as sunshine sensors do.
 *
 * @param everySeconds how often it measures; assumed
 * @param noise standard deviation, relative; assumed
 * @param worthTelling change of either light that is told, relative to what was told of it last;
 *     assumed
 */
public record FacadeData(double everySeconds, double noise, double worthTelling) {
  static final FacadeData USUAL = new FacadeData(30, 0.02, 0.1);
}
