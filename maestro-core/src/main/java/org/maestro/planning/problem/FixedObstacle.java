package org.maestro.planning.problem;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Extent;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;

/** Says of a condition that nobody can change what would be needed and what is so. */
public final class FixedObstacle {
  private FixedObstacle() {}

  /** A comparison of numbers that nobody ever changes. */
  static Obstacle ofNumbers(
      Formula.Comparison ground, boolean positive, double left, double right) {
    String relation = (positive ? "" : "not ") + ground.relation().symbol() + " ";
    boolean known = !Quantity.isUnknown(left) && !Quantity.isUnknown(right);
    return new Obstacle(
        known ? Kind.NUMBER : Kind.UNKNOWN,
        SlPrinter.print(positive ? ground : new Formula.Not(ground)),
        relation + (Quantity.isUnknown(right) ? "an unknown number" : SlPrinter.print(right)),
        Quantity.isUnknown(left) ? "unknown" : SlPrinter.print(left),
        Extent.KNOWN,
        known
            ? OptionalDouble.of(Quantity.rounded(Math.abs(right - left)))
            : OptionalDouble.empty(),
        Optional.empty(),
        Optional.empty(),
        List.of());
  }

  /** An atom that nobody ever changes. */
  static Obstacle ofAtom(Formula.Atom atom, boolean positive) {
    return positive
        ? stated(Kind.FACT, SlPrinter.print(atom), "true", "false")
        : stated(Kind.FACT, SlPrinter.print(new Formula.Not(atom)), "false", "true");
  }

  /** Of which is known what is needed and what is possible, and no more. */
  public static Obstacle stated(Kind kind, String condition, String needed, String possible) {
    return new Obstacle(
        kind,
        condition,
        needed,
        possible,
        Extent.KNOWN,
        OptionalDouble.empty(),
        Optional.empty(),
        Optional.empty(),
        List.of());
  }
}
