package org.maestro.knowledge.belief;

import java.util.List;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Facts in MAESTRO-SL. */
final class Wording {

  private Wording() {}

  static String holds(Formula.Atom atom, boolean truth) {
    return SlPrinter.print(truth ? new Fact.Holds(atom) : new Fact.Excluded(atom));
  }

  /**
   * @param has whether the variable has the value, or is known not to have it
   */
  static String value(StateVariable variable, Held held, boolean has) {
    if (held.value() instanceof Term.Number) {
      return equation(variable, held.value());
    } else if (held.value() instanceof Term.Truth truth) {
      return holds(atom(variable.predicate(), variable.arguments()), truth.value());
    }
    return holds(atom(variable.predicate(), variable.with(held.value())), has);
  }

  static String equation(StateVariable variable, Term value) {
    return SlPrinter.print(
        new Fact.Equation(
            new Expression.Fluent(variable.predicate(), variable.arguments()), value));
  }

  /** What the held value said is not known any more. */
  static String unknown(StateVariable variable, Held lost) {
    boolean valueIsNoArgument =
        lost.value() instanceof Term.Number || lost.value() instanceof Term.Truth;
    List<Term> arguments = valueIsNoArgument ? variable.arguments() : variable.with(lost.value());
    return SlPrinter.print(new Fact.Unknown(atom(variable.predicate(), arguments)));
  }

  private static Formula.Atom atom(String predicate, List<Term> arguments) {
    return new Formula.Atom(predicate, arguments);
  }
}
