package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** The ground variables met so far, one per state variable, atom or number. */
public final class Variables {
  private record Key(String predicate, List<Term> arguments) {}

  private final Signature signature;
  private final StaticFacts facts;
  private final Map<Key, Variable> variables = new HashMap<>();
  private final Map<Expression.Fluent, NumberVariable> numbers = new HashMap<>();
  private final Map<Term, Integer> rank = new HashMap<>();

  public Variables(Signature signature, StaticFacts facts) {
    this.signature = signature;
    this.facts = facts;
    facts.individuals("").forEach(individual -> rank.put(individual, rank.size()));
  }

  /** These atoms and fluents are otherwise than they were. */
  public void renew(Set<Object> changed) {
    for (Object asked : changed) {
      if (asked instanceof Formula.Atom atom) {
        known(atom).ifPresent(Variable::renew);
      } else if (asked instanceof Expression.Fluent fluent && numbers.containsKey(fluent)) {
        numbers.get(fluent).renew(facts.number(fluent));
      }
    }
  }

  /** What the atom says something of, if it was met before. */
  public Optional<Variable> known(Formula.Atom atom) {
    Optional<PredicateDeclaration> declaration = signature.declaration(atom.predicate());
    List<Term> arguments =
        signature.isFunctional(atom) ? withoutLast(atom.arguments()) : canonical(atom, declaration);
    return Optional.ofNullable(variables.get(new Key(atom.predicate(), arguments)));
  }

  public NumberVariable number(Expression.Fluent fluent) {
    return numbers.computeIfAbsent(
        fluent, absent -> new NumberVariable(fluent, facts.number(fluent)));
  }

  Variable variable(Formula.Atom atom) {
    Optional<PredicateDeclaration> declaration = signature.declaration(atom.predicate());
    boolean functional = signature.isFunctional(atom);
    List<Term> arguments =
        functional ? withoutLast(atom.arguments()) : canonical(atom, declaration);
    Key key = new Key(atom.predicate(), arguments);
    Variable known = variables.get(key);
    if (known == null) {
      boolean observable = declaration.map(PredicateDeclaration::observable).orElse(false);
      List<Term> possible = functional ? facts.individuals(lastClass(declaration)) : List.of();
      known = new Variable(atom.predicate(), arguments, functional, observable, facts, possible);
      variables.put(key, known);
    }
    return known;
  }

  /** The value of its variable that the atom states. */
  int value(Formula.Atom atom, Variable variable) {
    return variable.functional()
        ? variable.indexOf(atom.arguments().get(atom.arguments().size() - 1))
        : 0;
  }

  private List<Term> canonical(Formula.Atom atom, Optional<PredicateDeclaration> declaration) {
    List<Term> arguments = atom.arguments();
    if (arguments.size() != 2 || !declaration.map(PredicateDeclaration::symmetric).orElse(false)) {
      return arguments;
    }
    int first = rank.getOrDefault(arguments.get(0), Integer.MAX_VALUE);
    int second = rank.getOrDefault(arguments.get(1), Integer.MAX_VALUE);
    return first <= second ? arguments : List.of(arguments.get(1), arguments.get(0));
  }

  private static List<Term> withoutLast(List<Term> arguments) {
    return new ArrayList<>(arguments.subList(0, arguments.size() - 1));
  }

  private static String lastClass(Optional<PredicateDeclaration> declaration) {
    List<TypedVariable> parameters =
        declaration.map(PredicateDeclaration::parameters).orElse(List.of());
    return parameters.isEmpty() ? "" : parameters.get(parameters.size() - 1).className().orElse("");
  }
}
