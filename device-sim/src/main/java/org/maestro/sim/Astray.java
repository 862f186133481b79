package org.maestro.sim;

import org.maestro.hal.Position;
import org.maestro.ontology.home.Point2;

/** By how many metres a robot errs about where it is, along x and y. Immutable. */
record Astray(double xMetres, double yMetres) {
  static final Astray NOT = new Astray(0, 0);

  static Astray between(Point2 truth, Point2 believed) {
    return new Astray(believed.x() - truth.x(), believed.y() - truth.y());
  }

  /** Where who is there believes to be. */
  Point2 from(Point2 truth) {
    return equals(NOT) ? truth : new Point2(truth.x() + xMetres, truth.y() + yMetres);
  }

  /** What it reaches when it believes to reach that place. */
  Position reached(Position believed) {
    return equals(NOT)
        ? believed
        : new Position(believed.x() - xMetres, believed.y() - yMetres, believed.z());
  }
}
