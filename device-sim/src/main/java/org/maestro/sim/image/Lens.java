package org.maestro.sim.image;

import org.maestro.ontology.floor.Pose;

/**
 * A pin-hole: the directions in which the pixels look. The cone of view touches the picture's upper
 * and lower edge (assumed). Of a lens that looks straight down, the top of the picture is where y
 * is great.
 */
public final class Lens {

  private final Vector place;
  private final Vector ahead;
  private final Vector right;
  private final Vector up;
  private final int width;
  private final int height;
  private final double scale;

  /**
   * @param viewDegrees full angle of the cone of view, below 180
   * @param width of the picture; pixels
   * @param height of the picture; pixels
   */
  public Lens(Pose pose, double viewDegrees, int width, int height) {
    this.place = new Vector(pose.x(), pose.y(), pose.z());
    double yaw = Math.toRadians(pose.yaw());
    double pitch = Math.toRadians(pose.pitch());
    double level = Math.cos(pitch);
    this.ahead = new Vector(level * Math.cos(yaw), level * Math.sin(yaw), Math.sin(pitch));
    boolean steep = Math.abs(level) < 1e-9;
    // looking straight down the right-hand side would be anywhere: let it be x, turned by the yaw
    Vector side =
        steep
            ? new Vector(Math.cos(yaw), Math.sin(yaw), 0)
            : new Vector(Math.sin(yaw), -Math.cos(yaw), 0);
    double roll = Math.toRadians(pose.roll());
    Vector upright = side.cross(ahead);
    this.right = turned(side, upright, roll);
    this.up = turned(upright, side, -roll);
    this.width = width;
    this.height = height;
    this.scale = 2 * Math.tan(Math.toRadians(viewDegrees / 2)) / height;
  }

  private static Vector turned(Vector first, Vector second, double angle) {
    return new Vector(0, 0, 0).plus(first, Math.cos(angle)).plus(second, Math.sin(angle));
  }

  Vector place() {
    return place;
  }

  int width() {
    return width;
  }

  int height() {
    return height;
  }

  /** Not of length one. */
  Vector direction(int column, int row) {
    double x = (column + 0.5 - width / 2.0) * scale;
    double y = (height / 2.0 - row - 0.5) * scale;
    return ahead.plus(right, x).plus(up, y);
  }
}
