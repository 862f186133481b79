package org.maestro.sl;

import java.util.function.Consumer;

/** Visits the atoms and fluents of a formula in order, those inside quantifiers too. */
public final class Leaves {
  private final Consumer<Formula.Atom> atoms;
  private final Consumer<Expression.Fluent> fluents;

  private Leaves(Consumer<Formula.Atom> atoms, Consumer<Expression.Fluent> fluents) {
    this.atoms = atoms;
    this.fluents = fluents;
  }

  public static void of(
      Formula formula, Consumer<Formula.Atom> atoms, Consumer<Expression.Fluent> fluents) {
    new Leaves(atoms, fluents).visit(formula);
  }

  public static void of(Expression expression, Consumer<Expression.Fluent> fluents) {
    new Leaves(atom -> {}, fluents).visit(expression);
  }

  private void visit(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      atoms.accept(atom);
    } else if (formula instanceof Formula.Comparison comparison) {
      visit(comparison.left());
      visit(comparison.right());
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      atoms.accept(unknown.atom());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      fluents.accept(unknown.fluent());
    }
    formula.parts().forEach(this::visit);
  }

  private void visit(Expression expression) {
    if (expression instanceof Expression.Fluent fluent) {
      fluents.accept(fluent);
    } else if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(this::visit);
    }
  }
}
