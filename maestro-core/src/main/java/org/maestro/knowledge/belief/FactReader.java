package org.maestro.knowledge.belief;

import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeException;
import org.maestro.sl.Expression;
import org.maestro.sl.Fact;
import org.maestro.sl.Formula;
import org.maestro.sl.SlParser;
import org.maestro.sl.SlSyntaxException;
import org.maestro.sl.Term;

/** Reads what is said as ground facts. */
public final class FactReader {

  private FactReader() {}

  /**
   * @param speaker for the message, if it is no fact
   */
  public static Fact read(String text, String speaker) {
    try {
      Fact fact = SlParser.fact(text);
      if (!atom(fact).isGround()) {
        throw new KnowledgeException(
            "The fact " + text + " by " + speaker + " has variables; name the things in it.");
      }
      return fact instanceof Fact.Equation equation ? finite(equation) : fact;
    } catch (SlSyntaxException e) {
      throw new KnowledgeException(
          "The fact " + text + " by " + speaker + " is not MAESTRO-SL. " + e.getMessage(), e);
    }
  }

  /**
   * @throws KnowledgeException when its value is no finite number
   */
  static Fact.Equation finite(Fact.Equation equation) {
    if (equation.value() instanceof Term.Number number && !Double.isFinite(number.value())) {
      throw new KnowledgeException(
          "The value of "
              + equation.fluent().name()
              + " is not a finite number; say (unknown ...) instead.");
    }
    return equation;
  }

  public static Fact read(FeatureRun.Learnt learnt, String member) {
    Formula.Atom atom = atom(read(learnt.fact(), member));
    if (learnt.value() instanceof Term.Truth truth) {
      return truth.value() ? new Fact.Holds(atom) : new Fact.Excluded(atom);
    }
    return new Fact.Equation(
        new Expression.Fluent(atom.predicate(), atom.arguments()), learnt.value());
  }

  /** What the fact speaks of; a fluent is written as an atom. */
  public static Formula.Atom atom(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      return holds.atom();
    } else if (fact instanceof Fact.Excluded excluded) {
      return excluded.atom();
    } else if (fact instanceof Fact.Unknown unknown) {
      return unknown.atom();
    }
    Fact.Equation equation = (Fact.Equation) fact;
    return new Formula.Atom(equation.fluent().name(), equation.fluent().arguments());
  }
}
