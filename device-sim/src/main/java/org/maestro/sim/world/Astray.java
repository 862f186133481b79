package org.maestro.sim.world;

import org.maestro.hal.Position;
import org.maestro.ontology.floor.Point2;

/** By how many metres a robot errs about where it is, along x and y. Immutable. */
public record Astray(double xMetres, double yMetres) {
  static final Astray NOT = new Astray(0, 0);

  public static Astray between(Point2 truth, Point2 believed) {
    return new Astray(believed.x() - truth.x(), believed.y() - truth.y());
  }

  public Astray plus(double x, double y) {
    return new Astray(xMetres + x, yMetres + y);
  }

  public Astray times(double share) {
    return new Astray(share * xMetres, share * yMetres);
  }

  /** Whether it knows where it is. */
  public boolean isNot() {
    return equals(NOT);
  }

  /** Where that is which it believes to be there. */
  public Point2 truth(Point2 believed) {
    return equals(NOT) ? believed : new Point2(believed.x() - xMetres, believed.y() - yMetres);
  }

  /** Where who is there believes to be. */
  public Point2 from(Point2 truth) {
    return equals(NOT) ? truth : new Point2(truth.x() + xMetres, truth.y() + yMetres);
  }

  /** What it reaches when it believes to reach that place. */
  public Position reached(Position believed) {
    Point2 truth = truth(believed.floor());
    return new Position(truth.x(), truth.y(), believed.z());
  }
}
