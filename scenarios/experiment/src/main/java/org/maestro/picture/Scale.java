package org.maestro.picture;

import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.util.List;
import org.maestro.ontology.floor.Point2;
import org.maestro.ontology.floor.Polygon;

/** Metres of the floor to pixels of the picture, y upwards, with room for title and legend. */
record Scale(double left, double top, double pixelsPerMetre, int width, int heightPixels) {
  static final int MARGIN = 60;
  static final int TITLE = 90;
  static final int LEGEND = 190;

  static Scale of(List<Polygon> rooms, int width) {
    double left = Double.POSITIVE_INFINITY;
    double right = Double.NEGATIVE_INFINITY;
    double bottom = Double.POSITIVE_INFINITY;
    double top = Double.NEGATIVE_INFINITY;
    for (Polygon room : rooms) {
      for (Point2 corner : room.corners()) {
        left = Math.min(left, corner.x());
        right = Math.max(right, corner.x());
        bottom = Math.min(bottom, corner.y());
        top = Math.max(top, corner.y());
      }
    }
    double perMetre = (width - 2.0 * MARGIN) / (right - left);
    int height = (int) Math.ceil(TITLE + (top - bottom) * perMetre + LEGEND);
    return new Scale(left, top, perMetre, width, height);
  }

  Point2D at(Point2 point) {
    return new Point2D.Double(
        MARGIN + (point.x() - left) * pixelsPerMetre, TITLE + (top - point.y()) * pixelsPerMetre);
  }

  /** The part of the picture that shows the floor. */
  Rectangle2D floor() {
    return new Rectangle2D.Double(
        MARGIN, TITLE, width - 2.0 * MARGIN, heightPixels - (double) TITLE - LEGEND);
  }

  double pixels(double metres) {
    return metres * pixelsPerMetre;
  }

  Shape shape(Polygon outline) {
    Path2D path = new Path2D.Double();
    for (Point2 corner : outline.corners()) {
      Point2D pixel = at(corner);
      if (path.getCurrentPoint() == null) {
        path.moveTo(pixel.getX(), pixel.getY());
      } else {
        path.lineTo(pixel.getX(), pixel.getY());
      }
    }
    path.closePath();
    return path;
  }

  Shape circle(Point2 middle, double radiusMetres) {
    Point2D pixel = at(middle);
    double radius = pixels(radiusMetres);
    return new Ellipse2D.Double(
        pixel.getX() - radius, pixel.getY() - radius, 2 * radius, 2 * radius);
  }
}
