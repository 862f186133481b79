package org.maestro.sim.sky;

/**
 * The light outdoors at a moment.
 *
 * @param sun where it stands
 * @param directNormal light of the sun upon a surface turned to it; lux
 * @param clearHorizontal light of the sky's clear share upon level ground, without the sun; lux
 * @param overcastHorizontal light of its overcast share upon level ground; lux
 */
public record Outdoors(
    Sun sun, double directNormal, double clearHorizontal, double overcastHorizontal) {

  public static final Outdoors DARK = new Outdoors(new Sun(0, 0, -1), 0, 0, 0);

  /**
   * A wall sees half of an evenly bright sky (Liu and Jordan 1963), and 39.6 % of the light of the
   * CIE's overcast sky, which is three times as bright above as at the horizon (Moon and Spencer
   * 1942).
   */
  private static final double CLEAR_UPON_WALL = 0.5;

  private static final double OVERCAST_UPON_WALL = 0.396;

  /** Reflectance of the ground, of which a wall sees one half; the usual assumption. */
  private static final double GROUND = 0.2;

  /** Upon level ground, sun and sky together; lux. */
  public double horizontal() {
    return directNormal * Math.max(0, sun.up()) + clearHorizontal + overcastHorizontal;
  }

  /** Upon an upright wall from sky and ground, which comes from all sides; lux. */
  public double diffuseUponWall() {
    return CLEAR_UPON_WALL * clearHorizontal
        + OVERCAST_UPON_WALL * overcastHorizontal
        + GROUND / 2 * horizontal();
  }

  /**
   * Upon an upright wall straight from the sun; lux.
   *
   * @param east of the direction, of length 1, into which the wall's outside looks
   */
  public double sunUponWall(double east, double north) {
    return directNormal * Math.max(0, sun.east() * east + sun.north() * north);
  }
}
