package org.maestro.hal.sight;

import java.util.Optional;
import org.maestro.hal.Position;
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

  public Vector place() {
    return place;
  }

  public int width() {
    return width;
  }

  public int height() {
    return height;
  }

  /**
   * The direction in which a pixel looks; not of length one.
   *
   * @param column from the left, the middle of the first one is 0
   * @param row from above
   */
  public Vector direction(double column, double row) {
    double x = (column + 0.5 - width / 2.0) * scale;
    double y = (height / 2.0 - row - 0.5) * scale;
    return ahead.plus(right, x).plus(up, y);
  }

  /** Where a pixel's direction meets a level so high above the floor; empty when it never does. */
  Optional<Position> at(double column, double row, double height) {
    Vector direction = direction(column, row);
    double way = (height - place.z()) / direction.z();
    return way > 0 && Double.isFinite(way)
        ? Optional.of(
            new Position(place.x() + way * direction.x(), place.y() + way * direction.y(), height))
        : Optional.empty();
  }

  /**
   * The pixels on which an area is shown, which may lie beyond the picture's edge.
   *
   * @param squareMetres as seen from here
   * @param towards from here to its middle
   */
  double pixels(double squareMetres, Vector towards) {
    double deep = towards.dot(ahead);
    return deep <= 0 ? 0 : squareMetres * towards.length() / (deep * deep * deep * scale * scale);
  }

  /** The floor in the picture's middle; empty when that shows none. */
  public Optional<Position> middle() {
    return at((width - 1) / 2.0, (height - 1) / 2.0, 0);
  }

  /** A place in the picture: column from the left and row from above, of pixels' middles. */
  record Pixel(int column, int row) {}

  /**
   * The pixel that shows a point unless something hides it; empty when it is not in the picture.
   */
  Optional<Pixel> pixel(Vector point) {
    Vector towards = point.plus(place, -1);
    double deep = towards.dot(ahead);
    if (deep <= 0) {
      return Optional.empty();
    }
    double column = towards.dot(right) / (deep * scale) + width / 2.0;
    double row = height / 2.0 - towards.dot(up) / (deep * scale);
    return column >= 0 && column < width && row >= 0 && row < height
        ? Optional.of(new Pixel((int) column, (int) row))
        : Optional.empty();
  }
}
