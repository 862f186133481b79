package org.maestro.hal;

import org.maestro.ontology.floor.Point2;

/** A point in space; metres, z upwards from the floor. */
public record Position(double x, double y, double z) {
  private static final long MIXING = 0x9E3779B97F4A7C15L;

  /** Spreads points of a grid, which differ in few bits, over the whole range. */
  @Override
  public int hashCode() {
    long mixed = Double.doubleToLongBits(x);
    mixed = mixed * MIXING + Double.doubleToLongBits(y);
    mixed = mixed * MIXING + Double.doubleToLongBits(z);
    return (int) ((mixed * MIXING) >>> Integer.SIZE);
  }

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
