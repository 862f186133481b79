package org.maestro.hal;

import org.maestro.ontology.home.Point2;

/** A point in space; metres, z upwards from the floor. */
public record Position(double x, double y, double z) {

  public static Position onFloor(Point2 point) {
    return new Position(point.x(), point.y(), 0);
  }

  public Point2 floor() {
    return new Point2(x, y);
  }

  /** Straight distance; metres. */
  public double distance(Position other) {
    return Math.hypot(floor().distance(other.floor()), z - other.z);
  }
}
