package org.maestro.sl;

import java.util.List;

/**
 * The effect of a feature: facts and numbers that it adds, deletes, changes or senses. All values
 * on its right side are read before the step.
 */
public sealed interface Effect {

  record Add(Formula.Atom atom) implements Effect {}

  record Delete(Formula.Atom atom) implements Effect {}

  record All(List<Effect> effects) implements Effect {
    public All {
      effects = List.copyOf(effects);
    }
  }

  record When(Formula condition, Effect effect) implements Effect {}

  record Forall(List<TypedVariable> variables, Effect effect) implements Effect {
    public Forall {
      variables = List.copyOf(variables);
    }
  }

  record Change(Assignment assignment, Expression.Fluent fluent, Expression value)
      implements Effect {}

  /** In a plan an unknown atom becomes true; in the world nothing is written. */
  record SenseAtom(Formula.Atom atom) implements Effect {}

  /** In a plan an unknown number becomes "any"; in the world nothing is written. */
  record SenseNumber(Expression.Fluent fluent) implements Effect {}

  /** The assignment operators for numbers. */
  enum Assignment {
    ASSIGN("assign"),
    INCREASE("increase"),
    DECREASE("decrease");

    private final String word;

    Assignment(String word) {
      this.word = word;
    }

    public String word() {
      return word;
    }
  }
}
