package org.maestro.sim.parameters;

/**
 * A sensor of the air's warmth, as such sensors for rooms are.
 *
 * @param everySeconds how often it measures; assumed
 * @param noise standard deviation; kelvins. Data sheet of the Sensirion SHT40: repeatability 0.04
 * @param resolution its steps; kelvins. The same data sheet: 0.01
 * @param worthTelling difference to what it told last that it tells at once; kelvins, assumed
 * @param tellEverySeconds after which it tells any difference, so that what it told does not grow
 *     old; assumed
 */
public record ThermometerData(
    double everySeconds,
    double noise,
    double resolution,
    double worthTelling,
    double tellEverySeconds) {
  static final ThermometerData USUAL = new ThermometerData(60, 0.04, 0.01, 0.2, 600);

  public ThermometerData {
    PhysicalParameters.positive("thermometer.everySeconds", everySeconds);
    PhysicalParameters.positive("thermometer.resolution", resolution);
  }
}
