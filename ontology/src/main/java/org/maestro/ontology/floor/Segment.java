package org.maestro.ontology.floor;

/** A straight piece of the floor plan, such as a wall or a door's opening. */
public record Segment(Point2 from, Point2 to) {

  /** Positions along a wall closer than this are one; metres. */
  public static final double TOLERANCE = 1e-6;

  public double length() {
    return from.distance(to);
  }

  public Point2 middle() {
    return at(0.5);
  }

  /** The point at a share of the length, 0 at the beginning, 1 at the end. */
  public Point2 at(double share) {
    return new Point2(
        from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
  }

  /**
   * Whether the upright rectangles around both touch, as they do where both have a point in common.
   */
  boolean mayTouch(Segment other) {
    return Math.min(from.x(), to.x()) <= Math.max(other.from.x(), other.to.x()) + TOLERANCE
        && Math.min(other.from.x(), other.to.x()) <= Math.max(from.x(), to.x()) + TOLERANCE
        && Math.min(from.y(), to.y()) <= Math.max(other.from.y(), other.to.y()) + TOLERANCE
        && Math.min(other.from.y(), other.to.y()) <= Math.max(from.y(), to.y()) + TOLERANCE;
  }

  /** Whether both have a point in common, ends included. */
  public boolean intersects(Segment other) {
    double ofFrom = Point2.turn(from, to, other.from);
    double ofTo = Point2.turn(from, to, other.to);
    double ofThisFrom = Point2.turn(other.from, other.to, from);
    double ofThisTo = Point2.turn(other.from, other.to, to);
    if (ofFrom * ofTo < 0 && ofThisFrom * ofThisTo < 0) {
      return true;
    }
    return distance(other.from) <= TOLERANCE
        || distance(other.to) <= TOLERANCE
        || other.distance(from) <= TOLERANCE
        || other.distance(to) <= TOLERANCE;
  }

  /**
   * Where it enters, or leaves, an upright strip that it touches.
   *
   * @param least x of the strip
   * @param most x of the strip
   * @return y
   */
  double yWithin(double least, double most, boolean enters) {
    double width = to.x() - from.x();
    if (width == 0) {
      return enters ? from.y() : to.y();
    }
    double first = Math.max(0, Math.min(1, (least - from.x()) / width));
    double second = Math.max(0, Math.min(1, (most - from.x()) / width));
    double share = enters ? Math.min(first, second) : Math.max(first, second);
    return from.y() + share * (to.y() - from.y());
  }

  /** Shortest distance from a point; metres. */
  public double distance(Point2 point) {
    return at(Math.max(0, Math.min(1, share(point)))).distance(point);
  }

  /**
   * Where along the line the point's foot lies: 0 at the beginning, 1 at the end, beyond them
   * outside.
   */
  double share(Point2 point) {
    double dx = to.x() - from.x();
    double dy = to.y() - from.y();
    double squared = dx * dx + dy * dy;
    return squared == 0 ? 0 : ((point.x() - from.x()) * dx + (point.y() - from.y()) * dy) / squared;
  }

  /** Whether the other is a part of it, as a door's opening is of a wall. */
  public boolean covers(Segment other) {
    return isInLineWith(other)
        && distance(other.from) <= TOLERANCE
        && distance(other.to) <= TOLERANCE;
  }

  /** Whether the other lies on the same straight line. */
  public boolean isInLineWith(Segment other) {
    double length = length();
    return length > 0
        && Math.abs(Point2.turn(from, to, other.from)) / length <= 10 * TOLERANCE
        && Math.abs(Point2.turn(from, to, other.to)) / length <= 10 * TOLERANCE;
  }
}
