package org.maestro.sim.parameters;

/** The speed, size and power of a robot's base. */
public record BaseData(
    @Quantity(
            meaning = "speed of a driving robot",
            unit = "m/s",
            source = "youBot data sheet: 0.8; that it is reached at once is assumed")
        double speed,
    @Quantity(
            meaning = "radius of the circle around it",
            unit = "m",
            source = "youBot data sheet: 580 mm by 380 mm")
        double radius,
    @Quantity(
            meaning = "power while driving",
            unit = "W",
            source = "assumed from 24 V, 5 Ah and 90 minutes")
        double power,
    @Quantity(
            meaning = "how often the scanner looks for what came in the way",
            unit = "s",
            source = "assumed")
        double checkSeconds) {
  public static final BaseData YOUBOT = new BaseData(0.8, 0.347, 80, 0.25);

  public BaseData {
    PhysicalParameters.positive("base.speed", speed);
    PhysicalParameters.positive("base.checkSeconds", checkSeconds);
  }

  /** The same base at another speed; metres a second. */
  public BaseData atSpeed(double other) {
    return new BaseData(other, radius, power, checkSeconds);
  }

  /** The same base with another circle around it; metres. */
  public BaseData ofRadius(double other) {
    return new BaseData(speed, other, power, checkSeconds);
  }
}
