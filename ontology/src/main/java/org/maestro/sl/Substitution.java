package org.maestro.sl;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Predicate;
import java.util.function.Supplier;

/**
 * Replaces variables by terms. Variables that a quantifier binds stay; where a replacement would be
 * caught by a quantifier, the quantifier's variable is renamed. Immutable.
 *
 * @param terms by variable name, without question mark
 */
public record Substitution(Map<String, Term> terms) {
  public Substitution {
    terms = Collections.unmodifiableMap(new LinkedHashMap<>(terms));
  }

  public Term apply(Term term) {
    return term instanceof Term.Variable variable
        ? terms.getOrDefault(variable.name(), variable)
        : term;
  }

  public Formula.Atom apply(Formula.Atom atom) {
    return new Formula.Atom(atom.predicate(), apply(atom.arguments()));
  }

  public Expression.Fluent apply(Expression.Fluent fluent) {
    return new Expression.Fluent(fluent.name(), apply(fluent.arguments()));
  }

  public Expression apply(Expression expression) {
    if (expression instanceof Expression.OfTerm ofTerm) {
      return new Expression.OfTerm(apply(ofTerm.term()));
    } else if (expression instanceof Expression.Fluent fluent) {
      return apply(fluent);
    }
    Expression.Arithmetic arithmetic = (Expression.Arithmetic) expression;
    return new Expression.Arithmetic(
        arithmetic.operator(), arithmetic.operands().stream().map(this::apply).toList());
  }

  public Formula apply(Formula formula) {
    if (formula instanceof Formula.Atom atom) {
      return apply(atom);
    } else if (formula instanceof Formula.And and) {
      return new Formula.And(and.operands().stream().map(this::apply).toList());
    } else if (formula instanceof Formula.Or or) {
      return new Formula.Or(or.operands().stream().map(this::apply).toList());
    } else if (formula instanceof Formula.Not not) {
      return new Formula.Not(apply(not.operand()));
    } else if (formula instanceof Formula.Imply imply) {
      return new Formula.Imply(apply(imply.premise()), apply(imply.conclusion()));
    } else if (formula instanceof Formula.Exists exists) {
      return under(
          exists.variables(),
          () -> FreeVariables.of(exists.body()),
          (variables, inner) -> new Formula.Exists(variables, inner.apply(exists.body())));
    } else if (formula instanceof Formula.Forall forall) {
      return under(
          forall.variables(),
          () -> FreeVariables.of(forall.body()),
          (variables, inner) -> new Formula.Forall(variables, inner.apply(forall.body())));
    } else if (formula instanceof Formula.Comparison comparison) {
      return new Formula.Comparison(
          comparison.relation(), apply(comparison.left()), apply(comparison.right()));
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      return new Formula.UnknownAtom(apply(unknown.atom()));
    } else if (formula instanceof Formula.UnknownNumber unknown) {
      return new Formula.UnknownNumber(apply(unknown.fluent()));
    }
    if (formula instanceof Formula.Upon upon) {
      return new Formula.Upon(apply(upon.occasion()), apply(upon.goal()));
    } else if (formula instanceof Formula.Until until) {
      return new Formula.Until(apply(until.occasion()), apply(until.goal()));
    }
    return new Formula.Keep(apply(((Formula.Keep) formula).body()));
  }

  private Occasion apply(Occasion occasion) {
    return occasion instanceof Occasion.Event event
        ? new Occasion.Event(apply(event.condition()), event.again())
        : occasion;
  }

  public Effect apply(Effect effect) {
    if (effect instanceof Effect.Add add) {
      return new Effect.Add(apply(add.atom()));
    } else if (effect instanceof Effect.Delete delete) {
      return new Effect.Delete(apply(delete.atom()));
    } else if (effect instanceof Effect.All all) {
      return new Effect.All(all.effects().stream().map(this::apply).toList());
    } else if (effect instanceof Effect.When when) {
      return new Effect.When(apply(when.condition()), apply(when.effect()));
    } else if (effect instanceof Effect.Forall forall) {
      return under(
          forall.variables(),
          () -> FreeVariables.of(forall.effect()),
          (variables, inner) -> new Effect.Forall(variables, inner.apply(forall.effect())));
    } else if (effect instanceof Effect.Change change) {
      return new Effect.Change(change.assignment(), apply(change.fluent()), apply(change.value()));
    } else if (effect instanceof Effect.SenseAtom sense) {
      return new Effect.SenseAtom(apply(sense.atom()));
    }
    return new Effect.SenseNumber(apply(((Effect.SenseNumber) effect).fluent()));
  }

  public Content apply(Content content) {
    return new Content(content.operator(), applied(content.arguments()));
  }

  private List<Content.Argument> applied(List<Content.Argument> arguments) {
    return arguments.stream().map(this::apply).toList();
  }

  private Content.Argument apply(Content.Argument argument) {
    if (argument instanceof Content.Argument.OfFormula ofFormula) {
      return new Content.Argument.OfFormula(apply(ofFormula.formula()));
    } else if (argument instanceof Content.Argument.OfTerm ofTerm) {
      return new Content.Argument.OfTerm(apply(ofTerm.term()));
    } else if (argument instanceof Content.Argument.OfEffect ofEffect) {
      return new Content.Argument.OfEffect(apply(ofEffect.effect()));
    } else if (argument instanceof Content.Argument.Nested nested) {
      return new Content.Argument.Nested(apply(nested.content()));
    }
    Content.Argument.Named named = (Content.Argument.Named) argument;
    return new Content.Argument.Named(named.name(), applied(named.arguments()));
  }

  public Fact apply(Fact fact) {
    if (fact instanceof Fact.Holds holds) {
      return new Fact.Holds(apply(holds.atom()));
    } else if (fact instanceof Fact.Excluded excluded) {
      return new Fact.Excluded(apply(excluded.atom()));
    } else if (fact instanceof Fact.Equation equation) {
      return new Fact.Equation(apply(equation.fluent()), apply(equation.value()));
    }
    return new Fact.Unknown(apply(((Fact.Unknown) fact).atom()));
  }

  private List<Term> apply(List<Term> arguments) {
    return arguments.stream().map(this::apply).toList();
  }

  /**
   * Hands on the quantifier's variables, renamed where needed, and the substitution that holds
   * below them.
   */
  private <T> T under(
      List<TypedVariable> variables,
      Supplier<Set<String>> inside,
      BiFunction<List<TypedVariable>, Substitution, T> rebuilt) {
    Map<String, Term> below = new LinkedHashMap<>(terms);
    variables.forEach(variable -> below.remove(variable.name()));
    Predicate<TypedVariable> catches =
        variable -> below.containsValue(new Term.Variable(variable.name()));
    if (variables.stream().noneMatch(catches)) {
      return rebuilt.apply(variables, new Substitution(below));
    }
    // A new name must not catch anything either: nothing put in, nothing that was free before.
    Set<String> taken = new HashSet<>(inside.get());
    variables.forEach(variable -> taken.add(variable.name()));
    for (Term replacement : below.values()) {
      if (replacement instanceof Term.Variable variable) {
        taken.add(variable.name());
      }
    }
    List<TypedVariable> renamed = new ArrayList<>(variables);
    Map<String, Term> renaming = new LinkedHashMap<>();
    renamed.replaceAll(
        variable -> {
          if (!catches.test(variable)) {
            return variable;
          }
          String name = variable.name();
          while (!taken.add(name)) {
            name += "_";
          }
          renaming.put(variable.name(), new Term.Variable(name));
          return new TypedVariable(name, variable.className());
        });
    below.putAll(renaming);
    return rebuilt.apply(renamed, new Substitution(below));
  }
}
