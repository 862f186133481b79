package org.maestro.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.util.List;

/** A robot's path, drawn as a line with a ring where it began and arrows the way it went. */
final class Way {
  private static final double RING = 11;
  private static final double ARROW = 16;
  private static final double ARROWS_FROM = 90;

  private Way() {}

  /**
   * @param corners two or more
   */
  static void draw(Graphics2D canvas, List<Point2D> corners) {
    Path2D line = new Path2D.Double();
    Point2D first = corners.get(0);
    line.moveTo(first.getX(), first.getY());
    corners.forEach(corner -> line.lineTo(corner.getX(), corner.getY()));
    stroke(canvas, line, Color.WHITE, 9);
    stroke(canvas, line, Palette.ROBOT, 5);
    for (int i = 1; i < corners.size(); i++) {
      if (corners.get(i - 1).distance(corners.get(i)) > ARROWS_FROM) {
        arrow(canvas, corners.get(i - 1), corners.get(i));
      }
    }
    Shape ring = new Ellipse2D.Double(first.getX() - RING, first.getY() - RING, 2 * RING, 2 * RING);
    canvas.setColor(Color.WHITE);
    canvas.fill(ring);
    stroke(canvas, ring, Palette.ROBOT, 5);
  }

  /** Halfway, pointing from one corner to the next. */
  private static void arrow(Graphics2D canvas, Point2D from, Point2D to) {
    Path2D head = new Path2D.Double();
    head.moveTo(ARROW, 0);
    head.lineTo(-ARROW / 2, ARROW * 0.75);
    head.lineTo(-ARROW / 2, -ARROW * 0.75);
    head.closePath();
    AffineTransform place =
        AffineTransform.getTranslateInstance(
            (from.getX() + to.getX()) / 2, (from.getY() + to.getY()) / 2);
    place.rotate(to.getX() - from.getX(), to.getY() - from.getY());
    Shape placed = place.createTransformedShape(head);
    stroke(canvas, placed, Color.WHITE, 4);
    canvas.setColor(Palette.ROBOT);
    canvas.fill(placed);
  }

  private static void stroke(Graphics2D canvas, Shape shape, Color color, float width) {
    canvas.setColor(color);
    canvas.setStroke(new BasicStroke(width, BasicStroke.CAP_ROUND, BasicStroke.JOIN_ROUND));
    canvas.draw(shape);
  }
}
