package org.maestro.sim.parameters;

/**
 * The speed, size and power of a robot's base.
 *
 * @param speed youBot data sheet: 0.8 m/s; reached at once (assumed)
 * @param radius youBot data sheet: 580 mm by 380 mm, the circle around it
 * @param power watts while driving; assumed from 24 V, 5 Ah and 90 minutes
 * @param checkSeconds how often the scanner looks for what came in the way; assumed
 */
public record BaseData(double speed, double radius, double power, double checkSeconds) {
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
