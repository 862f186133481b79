package org.maestro.picture;

import java.awt.BasicStroke;
import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Arc2D;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Point2D;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;

/** The symbols of lamps, cameras, sensors, robots, persons and things. */
final class Symbols {
  /** Room around a lamp, camera, sensor or thing; pixels. */
  static final double SMALL = 18;

  /** Room around a robot or person; pixels. */
  static final double LARGE = 26;

  private static final double LAMP_RADIUS = 15;
  private static final double ROBOT_SIDE = 44;

  private Symbols() {}

  /** A disc filled as far as the lamp is lit. */
  static void lamp(Graphics2D canvas, Point2D at, double level) {
    Shape disc = disc(at, LAMP_RADIUS);
    canvas.setColor(Color.WHITE);
    canvas.fill(disc);
    canvas.setColor(Palette.LAMP);
    canvas.fill(
        new Arc2D.Double(
            at.getX() - LAMP_RADIUS,
            at.getY() - LAMP_RADIUS,
            2 * LAMP_RADIUS,
            2 * LAMP_RADIUS,
            90,
            -360 * level,
            Arc2D.PIE));
    edge(canvas, disc, 3);
  }

  /** A triangle that looks down. */
  static void camera(Graphics2D canvas, Point2D at) {
    Path2D triangle = new Path2D.Double();
    triangle.moveTo(at.getX() - 15, at.getY() - 11);
    triangle.lineTo(at.getX() + 15, at.getY() - 11);
    triangle.lineTo(at.getX(), at.getY() + 15);
    triangle.closePath();
    canvas.setColor(Palette.CAMERA);
    canvas.fill(triangle);
    edge(canvas, triangle, 2);
  }

  /** A diamond. */
  static void sensor(Graphics2D canvas, Point2D at) {
    Path2D diamond = new Path2D.Double();
    diamond.moveTo(at.getX(), at.getY() - 13);
    diamond.lineTo(at.getX() + 13, at.getY());
    diamond.lineTo(at.getX(), at.getY() + 13);
    diamond.lineTo(at.getX() - 13, at.getY());
    diamond.closePath();
    canvas.setColor(Color.WHITE);
    canvas.fill(diamond);
    edge(canvas, diamond, 3);
  }

  /** A square. */
  static void robot(Graphics2D canvas, Point2D at) {
    Shape square =
        new RoundRectangle2D.Double(
            at.getX() - ROBOT_SIDE / 2, at.getY() - ROBOT_SIDE / 2, ROBOT_SIDE, ROBOT_SIDE, 8, 8);
    canvas.setColor(Palette.ROBOT);
    canvas.fill(square);
    edge(canvas, square, 3);
  }

  /** A large disc with a small one in it: head and shoulders. */
  static void person(Graphics2D canvas, Point2D at) {
    Shape shoulders = disc(at, LARGE - 2);
    canvas.setColor(Palette.PERSON);
    canvas.fill(shoulders);
    edge(canvas, shoulders, 3);
    Shape head = disc(at, LARGE / 2.4);
    canvas.setColor(Color.WHITE);
    canvas.fill(head);
    edge(canvas, head, 2);
  }

  /** A small square on its side. */
  static void thing(Graphics2D canvas, Point2D at, Color colour) {
    Shape box = new Rectangle2D.Double(at.getX() - 10, at.getY() - 10, 20, 20);
    canvas.setColor(colour);
    canvas.fill(box);
    edge(canvas, box, 3);
  }

  /** Where a thing stood before: only its edge. */
  static void formerThing(Graphics2D canvas, Point2D at, Color colour) {
    Shape box = new Rectangle2D.Double(at.getX() - 10, at.getY() - 10, 20, 20);
    canvas.setColor(Color.WHITE);
    canvas.fill(box);
    canvas.setStroke(new BasicStroke(4));
    canvas.setColor(colour);
    canvas.draw(box);
  }

  private static Shape disc(Point2D at, double radius) {
    return new Ellipse2D.Double(at.getX() - radius, at.getY() - radius, 2 * radius, 2 * radius);
  }

  private static void edge(Graphics2D canvas, Shape shape, float width) {
    canvas.setStroke(new BasicStroke(width));
    canvas.setColor(Palette.INK);
    canvas.draw(shape);
  }
}
