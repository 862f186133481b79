package org.maestro.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Line2D;
import java.awt.geom.Point2D;
import org.maestro.ontology.floor.Segment;

/** Windows in a wall, and the shutters that cover them. */
final class Openings {
  private static final float GLASS = 9;
  private static final float SLATS = 13;
  private static final int JOIN = BasicStroke.JOIN_MITER;

  private Openings() {}

  /** A window, from above. */
  static void glass(Graphics2D canvas, Scale scale, Segment base) {
    glass(canvas, scale.at(base.from()), scale.at(base.to()));
  }

  static void glass(Graphics2D canvas, Point2D from, Point2D to) {
    Shape pane = new Line2D.Double(from, to);
    draw(canvas, pane, Palette.INK, new BasicStroke(GLASS + 4, BasicStroke.CAP_BUTT, JOIN));
    draw(canvas, pane, Color.WHITE, new BasicStroke(GLASS, BasicStroke.CAP_BUTT, JOIN));
    draw(canvas, pane, Palette.GLASS, new BasicStroke(GLASS - 3, BasicStroke.CAP_BUTT, JOIN));
  }

  /**
   * The part of a window that a shutter covers.
   *
   * @param closed 0 for none, 1 for all of it
   */
  static void shutter(Graphics2D canvas, Scale scale, Segment base, double closed) {
    if (closed > 0) {
      shutter(canvas, scale.at(base.from()), scale.at(base.at(closed)));
    }
  }

  static void shutter(Graphics2D canvas, Point2D from, Point2D to) {
    Shape covered = new Line2D.Double(from, to);
    draw(canvas, covered, Color.WHITE, new BasicStroke(SLATS, BasicStroke.CAP_BUTT, JOIN));
    draw(
        canvas,
        covered,
        Palette.INK,
        new BasicStroke(SLATS, BasicStroke.CAP_BUTT, JOIN, 10, new float[] {4, 3}, 0));
  }

  private static void draw(Graphics2D canvas, Shape shape, Color colour, BasicStroke stroke) {
    canvas.setStroke(stroke);
    canvas.setColor(colour);
    canvas.draw(shape);
  }
}
