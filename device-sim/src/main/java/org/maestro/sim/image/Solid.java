package org.maestro.sim.image;

import org.maestro.hal.sight.Paint;

/**
 * A body in the picture, standing upright.
 *
 * @param shape a box has both half lengths; a drum and a ball have the first one as radius
 * @param x middle of the foot; metres
 * @param bottom height of the foot above the floor; metres
 * @param top height above the floor; of a ball bottom plus twice its radius
 * @param heading of a box, from x towards y; radians
 * @param lux light upon its top
 */
public record Solid(
    Shape shape,
    double x,
    double y,
    double bottom,
    double top,
    double halfLength,
    double halfWidth,
    double heading,
    Paint colour,
    double lux) {

  /** The shape of a solid. */
  public enum Shape {
    BOX,
    DRUM,
    BALL
  }

  /** Of the circle around it on the floor; metres. */
  double reach() {
    return shape == Shape.BOX ? Math.hypot(halfLength, halfWidth) : halfLength;
  }
}
