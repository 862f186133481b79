package org.maestro.sim.parameters;

/** The wheels of a base: their geometry, slip and control. */
public record WheelData(
    @Quantity(meaning = "radius of a wheel", unit = "m", source = "KUKA youBot: 0.0475")
        double wheelRadius,
    @Quantity(
            meaning = "half the distance between the axles",
            unit = "m",
            source = "KUKA youBot: 0.471 between the axles")
        double halfLength,
    @Quantity(
            meaning = "half the distance between the wheels of an axle",
            unit = "m",
            source = "KUKA youBot: 0.300 between them")
        double halfWidth,
    @Quantity(
            meaning = "speed at which it turns on the spot",
            unit = "rad/s",
            source = "youBot data sheet: 90 degrees a second")
        double turnSpeed,
    @Quantity(
            meaning =
                "standard deviation around none of the share of each wheel's turning that is lost; the share of its way that a base without wheels of its own loses",
            unit = "1",
            source = "assumed: none, as no data sheet states one")
        double slip,
    @Quantity(meaning = "time between two commands to the wheels", unit = "s", source = "assumed")
        double controlSeconds,
    @Quantity(
            meaning = "distance at which a corner of its way counts as reached",
            unit = "m",
            source = "assumed")
        double nearMetres,
    @Quantity(
            meaning = "error of its heading with which a base that turns first drives on",
            unit = "rad",
            source = "assumed")
        double aimRadians) {
  static final WheelData YOUBOT =
      new WheelData(0.0475, 0.2355, 0.15, Math.PI / 2, 0, 0.1, 0.01, 0.05);
}
