package org.maestro.random;

import java.util.List;
import java.util.function.ToDoubleFunction;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * Whether a goal is so in the simulated world at one moment. What the sensors cannot tell from true
 * counts as close: 15 cm for distances and borders (four times what two cameras err at 2.8 m), 4 %
 * for light.
 */
final class Truths {
  static final double CLOSE_METRES = 0.15;
  static final double CLOSE_LIGHT = 0.04;
  private static final double NEXT_TO_METRES = 0.6;

  private final Moment moment;
  private final Site site;

  /** How true it is. */
  enum Grade {
    FALSE,
    CLOSE,
    TRUE;

    static Grade of(boolean truth, boolean close) {
      return truth ? TRUE : close ? CLOSE : FALSE;
    }

    Grade and(Grade other) {
      return compareTo(other) < 0 ? this : other;
    }

    Grade or(Grade other) {
      return compareTo(other) > 0 ? this : other;
    }
  }

  Truths(Moment moment, Site site) {
    this.moment = moment;
    this.site = site;
  }

  Grade of(Formula formula) {
    if (formula instanceof Formula.And and) {
      return and.operands().stream().map(this::of).reduce(Grade.TRUE, Grade::and);
    }
    if (formula instanceof Formula.Comparison comparison) {
      return comparison(comparison);
    }
    if (formula instanceof Formula.Atom atom) {
      return atom(atom.predicate(), atom.arguments());
    }
    throw new IllegalArgumentException("No judge of " + formula);
  }

  private Grade comparison(Formula.Comparison comparison) {
    Constraint constraint = Constraint.of(comparison);
    double lux = moment.zoneLux(constraint.zone());
    double slack = CLOSE_LIGHT * constraint.lux();
    double over = constraint.atLeast() ? lux - constraint.lux() : constraint.lux() - lux;
    return Grade.of(over >= 0, over >= -slack);
  }

  private Grade atom(String predicate, List<Term> arguments) {
    return switch (predicate) {
      case "in" -> in(name(arguments, 0), name(arguments, 1));
      case "nextTo" -> nextTo(name(arguments, 0), name(arguments, 1));
      case "open" -> Grade.of(moment.openDoors().contains(name(arguments, 0)), false);
      case "canSee" ->
          arguments.get(0) instanceof Term.Variable
              ? site.cameras().stream()
                  .map(camera -> canSee(camera, name(arguments, 1)))
                  .reduce(Grade.FALSE, Grade::or)
              : canSee(name(arguments, 0), name(arguments, 1));
      default -> throw new IllegalArgumentException("No judge of " + predicate);
    };
  }

  private Grade in(String thing, String place) {
    if (moment.holder(thing).isPresent()) {
      return Grade.of(moment.holder(thing).get().equals(place), false);
    }
    return site.floor().isZone(place)
        ? Grade.of(
            moment.zone(thing).filter(place::equals).isPresent(),
            site.floor().distance(place, moment.place(thing)) <= CLOSE_METRES)
        : Grade.FALSE;
  }

  private Grade nextTo(String first, String second) {
    if (moment.holder(first).isPresent() || moment.holder(second).isPresent()) {
      return Grade.FALSE;
    }
    double distance = moment.place(first).floor().distance(moment.place(second).floor());
    return Grade.of(distance <= NEXT_TO_METRES, distance <= NEXT_TO_METRES + CLOSE_METRES);
  }

  private Grade canSee(String camera, String thing) {
    if (!moment.isAlive(camera)
        || moment.isHidden(thing)
        || moment.holder(thing).isPresent()
        || !site.floor().sees(camera, moment.place(thing), moment.openDoors())) {
      return Grade.FALSE;
    }
    double lux = moment.lux(thing);
    return Grade.of(
        lux >= Site.CAMERA_LEAST_LUX && lux <= Site.CAMERA_GREATEST_LUX,
        lux >= Site.CAMERA_LEAST_LUX * (1 - 2 * CLOSE_LIGHT)
            && lux <= Site.CAMERA_GREATEST_LUX * (1 + 4 * CLOSE_LIGHT));
  }

  static String name(List<Term> arguments, int index) {
    return arguments.get(index) instanceof Term.Name name ? name.text() : "";
  }

  /** Light in a zone, from above or below. */
  record Constraint(String zone, double lux, boolean atLeast) {
    static Constraint of(Formula.Comparison comparison) {
      if (comparison.left() instanceof Expression.Fluent fluent
          && fluent.name().equals("illuminance")
          && comparison.right() instanceof Expression.OfTerm of
          && of.term() instanceof Term.Number number) {
        return new Constraint(
            name(fluent.arguments(), 0),
            number.value(),
            comparison.relation() == Formula.Relation.AT_LEAST);
      }
      throw new IllegalArgumentException("No judge of " + comparison);
    }

    boolean isMet(ToDoubleFunction<String> lux) {
      double margin = CLOSE_LIGHT * this.lux;
      return atLeast
          ? lux.applyAsDouble(zone) >= this.lux + margin
          : lux.applyAsDouble(zone) <= this.lux - margin;
    }
  }
}
