package org.maestro.sim.parameters;

/**
 * The wheels of a base: their geometry, slip and control.
 *
 * @param wheelRadius KUKA youBot: 0.0475 m; so are the following
 * @param halfLength half of 0.471 m between the axles
 * @param halfWidth half of 0.300 m between the wheels of an axle
 * @param turnSpeed youBot data sheet: 90 degrees a second
 * @param slip share of each wheel's turning that is lost, standard deviation around none; the share
 *     of its way that a base without wheels of its own loses. No data sheet states one: usually
 *     none
 * @param controlSeconds between two commands to the wheels; assumed
 * @param nearMetres so near to a corner of its way it counts as reached; assumed
 * @param aimRadians so well aimed, a base that turns first drives on; assumed
 */
public record WheelData(
    double wheelRadius,
    double halfLength,
    double halfWidth,
    double turnSpeed,
    double slip,
    double controlSeconds,
    double nearMetres,
    double aimRadians) {
  static final WheelData YOUBOT =
      new WheelData(0.0475, 0.2355, 0.15, Math.PI / 2, 0, 0.1, 0.01, 0.05);
}
