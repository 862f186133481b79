package org.maestro.sim.parameters;

/**
 * The light sensor on the outside of a shutter's window: it tells what the sun sends straight from
 * what comes from all sides, as sunshine sensors do.
 */
public record FacadeData(
    @Quantity(meaning = "time between two measurements", unit = "s", source = "assumed")
        double everySeconds,
    @Quantity(meaning = "standard deviation, relative", unit = "1", source = "assumed")
        double noise,
    @Quantity(
            meaning = "change of either light that is told, relative to what was told of it last",
            unit = "1",
            source = "assumed")
        double worthTelling) {
  static final FacadeData USUAL = new FacadeData(30, 0.02, 0.1);
}
