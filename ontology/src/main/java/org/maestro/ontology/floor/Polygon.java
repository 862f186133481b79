package org.maestro.ontology.floor;

import java.util.ArrayList;
import java.util.List;
import org.jspecify.annotations.Nullable;

/**
 * A simple polygon of the floor plan, such as a room's or a zone's outline; its last corner is
 * joined to its first. Immutable; equal to one of the same corners.
 */
public final class Polygon {
  private final List<Point2> corners;
  private final List<Segment> edges;
  private final Rectangle around;

  /**
   * @throws IllegalArgumentException for fewer than three corners
   */
  public Polygon(List<Point2> corners) {
    if (corners.size() < 3) {
      throw new IllegalArgumentException(
          "An outline needs three corners or more, but has " + corners.size() + ".");
    }
    this.corners = List.copyOf(corners);
    this.edges = joined(this.corners);
    this.around = Rectangle.around(this.corners);
  }

  /**
   * Reads {@code "x1 y1, x2 y2, ..."} in metres.
   *
   * @throws IllegalArgumentException when the text is anything else
   */
  public static Polygon parse(String outline) {
    List<Point2> corners = new ArrayList<>();
    for (String corner : outline.split(",")) {
      double[] numbers = Pose.numbers(corner);
      if (numbers.length != 2) {
        throw new IllegalArgumentException(
            "A corner of an outline is two numbers, but here is \"" + corner.strip() + "\".");
      }
      corners.add(new Point2(numbers[0], numbers[1]));
    }
    return new Polygon(corners);
  }

  /** Square metres. */
  public double area() {
    double twice = 0;
    for (Segment edge : edges) {
      twice += edge.from().x() * edge.to().y() - edge.to().x() * edge.from().y();
    }
    return Math.abs(twice) / 2;
  }

  public Point2 centroid() {
    double twice = 0;
    double x = 0;
    double y = 0;
    for (Segment edge : edges) {
      Point2 a = edge.from();
      Point2 b = edge.to();
      double cross = a.x() * b.y() - b.x() * a.y();
      twice += cross;
      x += (a.x() + b.x()) * cross;
      y += (a.y() + b.y()) * cross;
    }
    return new Point2(x / (3 * twice), y / (3 * twice));
  }

  public List<Point2> corners() {
    return corners;
  }

  public List<Segment> edges() {
    return edges;
  }

  private static List<Segment> joined(List<Point2> corners) {
    List<Segment> edges = new ArrayList<>();
    for (int i = 0; i < corners.size(); i++) {
      edges.add(new Segment(corners.get(i), corners.get((i + 1) % corners.size())));
    }
    return List.copyOf(edges);
  }

  /** Whether the point lies inside or on the edge. */
  public boolean contains(Point2 point) {
    if (!around.contains(point)) {
      return false;
    }
    boolean inside = false;
    for (Segment edge : edges) {
      if (edge.distance(point) <= Segment.TOLERANCE) {
        return true;
      }
      Point2 a = edge.from();
      Point2 b = edge.to();
      if (a.y() > point.y() != b.y() > point.y()
          && point.x() < (b.x() - a.x()) * (point.y() - a.y()) / (b.y() - a.y()) + a.x()) {
        inside = !inside;
      }
    }
    return inside;
  }

  /** The middle of the rectangle around. */
  public Point2 middle() {
    return new Point2((around.left() + around.right()) / 2, (around.bottom() + around.top()) / 2);
  }

  /** Metres from that middle within which all of it lies. */
  public double radius() {
    return Math.hypot(around.width(), around.height()) / 2;
  }

  /** Whether the rectangles around both touch: polygons of which they do not are apart. */
  public boolean isNear(Polygon other) {
    return around.touches(other.around);
  }

  /** Whether its edges meet at its corners only, and enclose a floor. */
  public boolean isSimple() {
    int count = edges.size();
    for (int i = 0; i < count; i++) {
      Segment edge = edges.get(i);
      Segment next = edges.get((i + 1) % count);
      if (edge.length() <= Segment.TOLERANCE
          || edge.distance(next.to()) <= Segment.TOLERANCE
          || next.distance(edge.from()) <= Segment.TOLERANCE) {
        return false;
      }
      for (int j = i + 2; j < count; j++) {
        if ((j + 1) % count != i && edge.intersects(edges.get(j))) {
          return false;
        }
      }
    }
    return true;
  }

  /** The length of edge that both share; metres. */
  public double sharedEdge(Polygon other) {
    double shared = 0;
    for (Segment edge : edges) {
      for (Segment opposite : other.edges()) {
        if (edge.isInLineWith(opposite)) {
          double first = edge.share(opposite.from());
          double second = edge.share(opposite.to());
          double overlap =
              Math.min(1, Math.max(first, second)) - Math.max(0, Math.min(first, second));
          shared += Math.max(0, overlap) * edge.length();
        }
      }
    }
    return shared;
  }

  /**
   * Points of a grid that lie inside, none of them on the border of the rectangle around, for areas
   * that are measured by sampling.
   *
   * @param spacing metres, at most
   */
  public List<Point2> samples(double spacing) {
    int columns = cells(around.width(), spacing);
    int rows = cells(around.height(), spacing);
    List<Point2> samples = new ArrayList<>();
    for (int column = 0; column < columns; column++) {
      for (int row = 0; row < rows; row++) {
        Point2 point =
            new Point2(
                around.left() + (column + 0.5) * around.width() / columns,
                around.bottom() + (row + 0.5) * around.height() / rows);
        if (contains(point)) {
          samples.add(point);
        }
      }
    }
    return samples;
  }

  private static int cells(double length, double spacing) {
    return Math.max(1, (int) Math.ceil(length / spacing - Segment.TOLERANCE));
  }

  @Override
  public boolean equals(@Nullable Object other) {
    return other instanceof Polygon polygon && corners.equals(polygon.corners);
  }

  @Override
  public int hashCode() {
    return corners.hashCode();
  }

  @Override
  public String toString() {
    return corners.toString();
  }
}
