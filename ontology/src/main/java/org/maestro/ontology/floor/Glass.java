package org.maestro.ontology.floor;

/**
 * Upright glass in a wall: a uniformly diffusing area source of light for the room behind it.
 * Immutable.
 *
 * @param base its lower edge on the floor plan
 * @param sill height of the lower edge; metres
 * @param head height of the upper edge; metres
 * @param transmittance share of the light that it lets through, 0 to 1
 * @param inwardX across the wall into the room, of length 1
 */
public record Glass(
    Segment base, double sill, double head, double transmittance, double inwardX, double inwardY) {

  /** Two clear panes let through about so much (EN 410). */
  public static final double USUAL_TRANSMITTANCE = 0.78;

  /** Into so many upright strips it is divided where something may stand before a part of it. */
  private static final int STRIPS = 8;

  /** Sight is asked for from so far within the room, as the glass itself is part of a wall. */
  private static final double WITHIN_METRES = 0.01;

  /** Square metres. */
  public double area() {
    return base.length() * (head - sill);
  }

  /**
   * The light on a horizontal surface at a point of the room, as a share of the light that comes
   * through each part of the glass (the configuration factor): by Lambert's formula for a polygon
   * that gives light evenly, as in Arvo, "Analytic methods for simulated light transport" (1995),
   * section 3; the glass below the point's height counts nothing. Parts that a wall hides from the
   * point are left out.
   */
  public double factor(double x, double y, double z, FloorPlan plan) {
    Point2 point = new Point2(x, y);
    double bottom = Math.max(sill, z) - z;
    double top = head - z;
    if (top <= bottom || inside(point) <= 0) {
      return 0;
    }
    double factor = 0;
    for (int strip = 0; strip < STRIPS; strip++) {
      Point2 from = base.at((double) strip / STRIPS);
      Point2 to = base.at((strip + 1.0) / STRIPS);
      if (isSeenFrom(point, base.at((strip + 0.5) / STRIPS), plan)) {
        factor += rectangle(from.plus(-x, -y), to.plus(-x, -y), bottom, top);
      }
    }
    return factor;
  }

  /** How far a point lies before the inner side of the glass; metres, negative outdoors. */
  public double inside(Point2 point) {
    return (point.x() - base.from().x()) * inwardX + (point.y() - base.from().y()) * inwardY;
  }

  /** Whether a point of the glass can be seen from one within; its height does not matter. */
  public boolean isSeenFrom(Point2 within, Point2 ofGlass, FloorPlan plan) {
    return !plan.isBlocked(within, ofGlass.plus(WITHIN_METRES * inwardX, WITHIN_METRES * inwardY));
  }

  /** Whether a point of the wall lies between both sides of the glass. */
  public boolean isInBreadth(Point2 ofWall) {
    double share = base.share(ofWall);
    return share >= 0 && share <= 1;
  }

  /** Half the sum, over the edges, of the angle under which each is seen times its upward part. */
  private static double rectangle(Point2 from, Point2 to, double bottom, double top) {
    double[][] corners = {
      {from.x(), from.y(), bottom},
      {to.x(), to.y(), bottom},
      {to.x(), to.y(), top},
      {from.x(), from.y(), top}
    };
    double sum = 0;
    for (int i = 0; i < corners.length; i++) {
      double[] a = corners[i];
      double[] b = corners[(i + 1) % corners.length];
      double crossX = a[1] * b[2] - a[2] * b[1];
      double crossY = a[2] * b[0] - a[0] * b[2];
      double crossZ = a[0] * b[1] - a[1] * b[0];
      double cross = Math.sqrt(crossX * crossX + crossY * crossY + crossZ * crossZ);
      double dot = a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
      if (cross > 0) {
        sum += Math.atan2(cross, dot) * crossZ / cross;
      }
    }
    return Math.abs(sum) / (2 * Math.PI);
  }

  /** Reads a corner of glass, {@code "x y z"}. */
  public static double[] corner(String text) {
    double[] numbers = Pose.numbers(text);
    if (numbers.length != 3) {
      throw new IllegalArgumentException("A corner of glass is three numbers.");
    }
    return numbers;
  }
}
