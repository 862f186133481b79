package org.maestro.sim.parameters;

/**
 * The range, integration time and noise of a light sensor.
 *
 * @param leastLux TSL2561 data sheet: 0.1 lux; also its resolution here
 * @param greatestLux TSL2561 data sheet: 40,000 lux
 * @param integrationSeconds TSL2561 data sheet: nominal 402 ms
 * @param noise standard deviation, relative; assumed 1 %
 */
public record SensorData(
    double leastLux, double greatestLux, double integrationSeconds, double noise) {
  static final SensorData TSL2561 = new SensorData(0.1, 40_000, 0.402, 0.01);

  /**
   * @param other standard deviation, relative
   */
  public SensorData withNoise(double other) {
    return new SensorData(leastLux, greatestLux, integrationSeconds, other);
  }
}
