package org.maestro.random;

import java.util.List;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * The truth of goals in the simulated world at one moment. What the sensors cannot tell from true
 * counts as close: 15 cm for distances and borders (four times what two cameras err at 2.8 m), 4 %
 * for light, and that a thing is nowhere in sight when it is shut away where it should not be.
 */
final class Truths {
  static final double CLOSE_METRES = 0.15;
  static final double CLOSE_LIGHT = 0.04;
  private static final double NEXT_TO_METRES = 0.6;

  private final Moment moment;
  private final Site site;

  /** The degree of truth: false, close to true, or true. */
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

  /**
   * @param formula spelled out
   */
  Grade of(Formula formula) {
    if (formula instanceof Formula.And and) {
      return and.operands().stream().map(this::of).reduce(Grade.TRUE, Grade::and);
    }
    if (formula instanceof Formula.Or or) {
      return or.operands().stream().map(this::of).reduce(Grade.FALSE, Grade::or);
    }
    if (formula instanceof Formula.Not not && not.operand() instanceof Formula.Atom atom) {
      return not(atom.predicate(), atom.arguments());
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
    double number =
        constraint.isOfLight()
            ? moment.light(constraint.subject())
            : moment.levels().get(constraint.subject());
    double slack = constraint.isOfLight() ? CLOSE_LIGHT * constraint.number() : 0;
    double over =
        constraint.atLeast() ? number - constraint.number() : constraint.number() - number;
    return Grade.of(over >= 0, over >= -slack);
  }

  private Grade not(String predicate, List<Term> arguments) {
    String first = name(arguments, 0);
    String second = name(arguments, arguments.size() - 1);
    boolean isSo = atom(predicate, arguments) == Grade.TRUE;
    return switch (predicate) {
      case "in" ->
          Grade.of(
              !isSo,
              site.floor().isZone(second)
                  && moment.holder(first).isEmpty()
                  && (moment.isHidden(first)
                      || site.floor().borderDistance(second, moment.place(first)) <= CLOSE_METRES));
      case "nextTo" ->
          Grade.of(
              !isSo,
              moment.place(first).floor().distance(moment.place(second).floor())
                  > NEXT_TO_METRES - CLOSE_METRES);
      case "open" -> Grade.of(!isSo, false);
      default -> throw new IllegalArgumentException("No judge of not " + predicate);
    };
  }

  private Grade atom(String predicate, List<Term> arguments) {
    return switch (predicate) {
      case "in" -> in(name(arguments, 0), name(arguments, 1));
      case "nextTo" -> nextTo(name(arguments, 0), name(arguments, 1));
      case "open" -> Grade.of(moment.openDoors().contains(name(arguments, 0)), false);
      case "canSee" ->
          site.cameras().contains(name(arguments, 0))
              ? canSee(name(arguments, 0), name(arguments, 1))
              : Grade.FALSE;
      default -> throw new IllegalArgumentException("No judge of " + predicate);
    };
  }

  private Grade in(String thing, String place) {
    if (!moment.places().containsKey(thing)) {
      return Grade.FALSE;
    }
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
    if (first.equals(second)
        || moment.holder(first).isPresent()
        || moment.holder(second).isPresent()) {
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

  /** The light of a location, or the level of a lamp, from above or below. */
  record Constraint(String fluent, String subject, double number, boolean atLeast) {
    static Constraint light(String location, double lux, boolean atLeast) {
      return new Constraint("illuminance", location, lux, atLeast);
    }

    static Constraint of(Formula.Comparison comparison) {
      if (comparison.left() instanceof Expression.Fluent fluent
          && List.of("illuminance", "level").contains(fluent.name())
          && comparison.right() instanceof Expression.OfTerm of
          && of.term() instanceof Term.Number number) {
        return new Constraint(
            fluent.name(),
            name(fluent.arguments(), 0),
            number.value(),
            comparison.relation() == Formula.Relation.AT_LEAST);
      }
      throw new IllegalArgumentException("No judge of " + comparison);
    }

    boolean isOfLight() {
      return fluent.equals("illuminance");
    }
  }
}
