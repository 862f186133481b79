package org.maestro.ontology.floor;

/** A point of the floor plan; metres. */
public record Point2(double x, double y) {

  public double distance(Point2 other) {
    double dx = other.x - x;
    double dy = other.y - y;
    return Math.sqrt(dx * dx + dy * dy);
  }

  public Point2 plus(double dx, double dy) {
    return new Point2(x + dx, y + dy);
  }

  /** Positive when the point lies left of the way from {@code from} to {@code to}. */
  static double turn(Point2 from, Point2 to, Point2 point) {
    return (to.x - from.x) * (point.y - from.y) - (to.y - from.y) * (point.x - from.x);
  }
}
