package org.maestro.sl;

import java.util.ArrayDeque;
import java.util.Collections;
import java.util.Deque;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;

/**
 * The variables of a tree that no quantifier inside it binds, in the order of their first
 * appearance.
 */
public final class FreeVariables {

  private final Set<String> found = new LinkedHashSet<>();
  private final Deque<String> bound = new ArrayDeque<>();

  private FreeVariables() {}

  public static Set<String> of(Formula formula) {
    FreeVariables variables = new FreeVariables();
    variables.visit(formula);
    return Collections.unmodifiableSet(variables.found);
  }

  public static Set<String> of(Effect effect) {
    FreeVariables variables = new FreeVariables();
    variables.visit(effect);
    return Collections.unmodifiableSet(variables.found);
  }

  public static Set<String> of(Expression expression) {
    FreeVariables variables = new FreeVariables();
    variables.visit(expression);
    return Collections.unmodifiableSet(variables.found);
  }

  public static Set<String> of(Content content) {
    FreeVariables variables = new FreeVariables();
    content.arguments().forEach(variables::visit);
    return Collections.unmodifiableSet(variables.found);
  }

  private void visit(Content.Argument argument) {
    if (argument instanceof Content.Argument.OfFormula ofFormula) {
      visit(ofFormula.formula());
    } else if (argument instanceof Content.Argument.OfTerm ofTerm) {
      visit(ofTerm.term());
    } else if (argument instanceof Content.Argument.OfEffect ofEffect) {
      visit(ofEffect.effect());
    } else if (argument instanceof Content.Argument.Nested nested) {
      nested.content().arguments().forEach(this::visit);
    } else if (argument instanceof Content.Argument.Named named) {
      named.arguments().forEach(this::visit);
    }
  }

  public static Set<String> of(Fact fact) {
    FreeVariables variables = new FreeVariables();
    if (fact instanceof Fact.Holds holds) {
      variables.visit(holds.atom().arguments());
    } else if (fact instanceof Fact.Excluded excluded) {
      variables.visit(excluded.atom().arguments());
    } else if (fact instanceof Fact.Unknown unknown) {
      variables.visit(unknown.atom().arguments());
    } else if (fact instanceof Fact.Equation equation) {
      variables.visit(equation.fluent());
      variables.visit(equation.value());
    }
    return Collections.unmodifiableSet(variables.found);
  }

  private void visit(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      visit(atom.arguments());
    } else if (formula instanceof Formula.Exists exists) {
      under(exists.variables(), () -> visit(exists.body()));
    } else if (formula instanceof Formula.Forall forall) {
      under(forall.variables(), () -> visit(forall.body()));
    } else if (formula instanceof Formula.Comparison comparison) {
      visit(comparison.left());
      visit(comparison.right());
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      visit(unknown.atom().arguments());
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      visit(unknown.fluent());
    } else {
      formula.parts().forEach(this::visit);
    }
  }

  private void visit(Effect effect) {
    if (effect instanceof Effect.Add add) {
      visit(add.atom().arguments());
    } else if (effect instanceof Effect.Delete delete) {
      visit(delete.atom().arguments());
    } else if (effect instanceof Effect.All all) {
      all.effects().forEach(this::visit);
    } else if (effect instanceof Effect.When when) {
      visit(when.condition());
      visit(when.effect());
    } else if (effect instanceof Effect.Forall forall) {
      under(forall.variables(), () -> visit(forall.effect()));
    } else if (effect instanceof Effect.Change change) {
      visit(change.fluent());
      visit(change.value());
    } else if (effect instanceof Effect.SenseAtom sense) {
      visit(sense.atom().arguments());
    } else if (effect instanceof Effect.SenseNumber sense) {
      visit(sense.fluent());
    }
  }

  private void visit(Expression expression) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      visit(ofTerm.term());
    } else if (expression instanceof Expression.Fluent fluent) {
      visit(fluent.arguments());
    } else if (expression instanceof Expression.Arithmetic arithmetic) {
      arithmetic.operands().forEach(this::visit);
    }
  }

  private void visit(List<Term> terms) {
    terms.forEach(this::visit);
  }

  private void visit(Term term) {
    if (term instanceof Term.Variable variable && !bound.contains(variable.name())) {
      found.add(variable.name());
    }
  }

  private void under(List<TypedVariable> variables, Runnable inside) {
    variables.forEach(variable -> bound.push(variable.name()));
    inside.run();
    variables.forEach(variable -> bound.pop());
  }
}
