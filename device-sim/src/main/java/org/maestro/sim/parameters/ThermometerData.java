package org.maestro.sim.parameters;

/** A sensor of the air's warmth, as such sensors for rooms are. */
public record ThermometerData(
    @Quantity(meaning = "time between two measurements", unit = "s", source = "assumed")
        double everySeconds,
    @Quantity(
            meaning = "standard deviation",
            unit = "K",
            source = "data sheet of the Sensirion SHT40: repeatability 0.04")
        double noise,
    @Quantity(meaning = "its steps", unit = "K", source = "data sheet of the Sensirion SHT40: 0.01")
        double resolution,
    @Quantity(
            meaning = "difference to what it told last that it tells at once",
            unit = "K",
            source = "assumed")
        double worthTelling,
    @Quantity(
            meaning =
                "time after which it tells any difference, so that what it told does not grow old",
            unit = "s",
            source = "assumed")
        double tellEverySeconds) {
  static final ThermometerData USUAL = new ThermometerData(60, 0.04, 0.01, 0.2, 600);

  public ThermometerData {
    PhysicalParameters.positive("thermometer.everySeconds", everySeconds);
    PhysicalParameters.positive("thermometer.resolution", resolution);
  }
}
