package org.maestro.ontology.floor;

import java.util.List;

/** An upright rectangle of the floor plan, which tells cheaply what is far from what; metres. */
record Rectangle(double left, double right, double bottom, double top) {

  static Rectangle around(List<Point2> points) {
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double bottom = Double.POSITIVE_INFINITY;
    double top = Double.NEGATIVE_INFINITY;
    for (Point2 point : points) {
      left = Math.min(left, point.x());
      right = Math.max(right, point.x());
      bottom = Math.min(bottom, point.y());
      top = Math.max(top, point.y());
    }
    return new Rectangle(left, right, bottom, top);
  }

  double width() {
    return right - left;
  }

  double height() {
    return top - bottom;
  }

  /** Whether the point lies inside, on the border or beside it by no more than rounding. */
  boolean contains(Point2 point) {
    return point.x() >= left - Segment.TOLERANCE
        && point.x() <= right + Segment.TOLERANCE
        && point.y() >= bottom - Segment.TOLERANCE
        && point.y() <= top + Segment.TOLERANCE;
  }

  /** Whether both have a point in common, but for rounding. */
  boolean touches(Rectangle other) {
    return left <= other.right + Segment.TOLERANCE
        && other.left <= right + Segment.TOLERANCE
        && bottom <= other.top + Segment.TOLERANCE
        && other.bottom <= top + Segment.TOLERANCE;
  }
}
