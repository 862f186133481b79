package org.maestro.knowledge.belief;

import java.time.Instant;
import org.maestro.knowledge.api.Belief;
import org.maestro.knowledge.api.StateVariable;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * A statement from before a restart. It counts no more.
 *
 * @param has whether the variable had the value, or was known not to have it
 */
public record Remembered(StateVariable variable, Held held, boolean has) {

  public static Remembered of(Declarations declarations, Belief belief, long serial) {
    Fact fact = FactReader.read(belief.fact(), belief.source().agent());
    if (fact instanceof Fact.Equation equation) {
      StateVariable variable =
          new StateVariable(equation.fluent().name(), equation.fluent().arguments());
      return new Remembered(variable, held(belief, equation.value(), serial), true);
    }
    Formula.Atom atom = declarations.canonical(FactReader.atom(fact));
    boolean holds = fact instanceof Fact.Holds;
    boolean functional = declarations.isFunctional(atom.predicate());
    Term value = functional ? declarations.valueOf(atom) : new Term.Truth(holds);
    return new Remembered(
        declarations.variable(atom), held(belief, value, serial), holds || !functional);
  }

  private static Held held(Belief belief, Term value, long serial) {
    return new Held(
        value,
        belief.source(),
        belief.since(),
        Instant.MIN,
        belief.since(),
        belief.confidence(),
        false,
        belief.coveredShare(),
        serial);
  }

  public Outcome.News news() {
    return new Outcome.News(variable, held, has, false);
  }
}
