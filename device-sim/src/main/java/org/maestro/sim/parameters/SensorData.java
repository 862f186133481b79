package org.maestro.sim.parameters;

/** The range, integration time and noise of a light sensor. */
public record SensorData(
    @Quantity(
            meaning = "least light that it tells, and its resolution here",
            unit = "lux",
            source = "TSL2561 data sheet: 0.1")
        double leastLux,
    @Quantity(
            meaning = "most light that it tells",
            unit = "lux",
            source = "TSL2561 data sheet: 40,000")
        double greatestLux,
    @Quantity(
            meaning = "time of a measurement",
            unit = "s",
            source = "TSL2561 data sheet: nominal 402 ms")
        double integrationSeconds,
    @Quantity(meaning = "standard deviation, relative", unit = "1", source = "assumed: 1 %")
        double noise) {
  static final SensorData TSL2561 = new SensorData(0.1, 40_000, 0.402, 0.01);

  /**
   * @param other standard deviation, relative
   */
  public SensorData withNoise(double other) {
    return new SensorData(leastLux, greatestLux, integrationSeconds, other);
  }
}
