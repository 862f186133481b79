package org.maestro.sl;

/**
 * A single statement, as members report it and knowledge keeps it. Variables are allowed in it, so
 * that it may be a template such as {@code (= (level ?self) ?level)}.
 */
public sealed interface Fact {

  /**
   * {@code (in Cup zone-b)}; a bare fluent such as {@code (illuminance zone-b)} reads as this too.
   */
  record Holds(Formula.Atom atom) implements Fact {

    /** The same words understood as a number's name. */
    public Expression.Fluent asFluent() {
      return new Expression.Fluent(atom.predicate(), atom.arguments());
    }
  }

  /** {@code (not (in Cup zone-b))}: known not to hold. */
  record Excluded(Formula.Atom atom) implements Fact {}

  /** {@code (= (illuminance zone-b) 17)}. */
  record Equation(Expression.Fluent fluent, Term value) implements Fact {}

  /** {@code (unknown (in Cup zone-b))}, {@code (unknown (illuminance zone-b))}. */
  record Unknown(Formula.Atom atom) implements Fact {}
}
