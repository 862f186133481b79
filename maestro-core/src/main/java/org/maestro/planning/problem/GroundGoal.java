package org.maestro.planning.problem;

import java.util.ArrayList;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.planning.problem.Condition.Constant;
import org.maestro.sl.Expression;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/**
 * A goal with one alternative for each possible binding of its free variables, in the order of the
 * individuals.
 */
public record GroundGoal(List<Alternative> alternatives) {

  public record Alternative(Map<String, Term> binding, Condition condition) {}

  public static GroundGoal of(
      Formula goal, Signature signature, StaticFacts facts, ConditionCompiler conditions) {
    List<Alternative> alternatives = new ArrayList<>();
    Set<String> free = FreeVariables.of(goal);
    choose(
        goal, signature, facts, conditions, List.copyOf(free), new LinkedHashMap<>(), alternatives);
    return new GroundGoal(List.copyOf(alternatives));
  }

  private static void choose(
      Formula goal,
      Signature signature,
      StaticFacts facts,
      ConditionCompiler conditions,
      List<String> free,
      Map<String, Term> binding,
      List<Alternative> alternatives) {
    if (binding.size() == free.size()) {
      Condition condition = conditions.condition(goal, binding);
      if (condition != Constant.FALSE) {
        Map<String, Term> copy = Collections.unmodifiableMap(new LinkedHashMap<>(binding));
        alternatives.add(new Alternative(copy, condition));
      }
      return;
    }
    String name = free.get(binding.size());
    for (Term value : domain(name, goal, signature, facts)) {
      binding.put(name, value);
      choose(goal, signature, facts, conditions, free, binding, alternatives);
      binding.remove(name);
    }
  }

  /** The individuals that fit every declared argument at which the variable stands. */
  private static List<Term> domain(
      String variable, Formula goal, Signature signature, StaticFacts facts) {
    Set<String> classes = new LinkedHashSet<>();
    collectClasses(goal, variable, signature, classes);
    Set<Term> fitting = new LinkedHashSet<>(facts.individuals(""));
    classes.forEach(name -> fitting.retainAll(Set.copyOf(facts.individuals(name))));
    return List.copyOf(fitting);
  }

  private static void collectClasses(
      Formula formula, String variable, Signature signature, Set<String> classes) {
    if (formula instanceof Formula.Atom atom) {
      collect(atom.predicate(), atom.arguments(), variable, signature, classes);
    } else if (formula instanceof Formula.UnknownAtom unknown) {
      collectClasses(unknown.atom(), variable, signature, classes);
    } else if (formula instanceof Formula.And and) {
      and.operands().forEach(part -> collectClasses(part, variable, signature, classes));
    } else if (formula instanceof Formula.Not not) {
      collectClasses(not.operand(), variable, signature, classes);
    } else if (formula instanceof Formula.Exists exists) {
      collectClasses(exists.body(), variable, signature, classes);
    } else if (formula instanceof Formula.Keep keep) {
      collectClasses(keep.body(), variable, signature, classes);
    } else if (formula instanceof Formula.Comparison comparison) {
      for (Expression side : List.of(comparison.left(), comparison.right())) {
        if (side instanceof Expression.Fluent fluent) {
          collect(fluent.name(), fluent.arguments(), variable, signature, classes);
        }
      }
    }
  }

  private static void collect(
      String name,
      List<Term> arguments,
      String variable,
      Signature signature,
      Set<String> classes) {
    List<TypedVariable> parameters =
        signature.declaration(name).map(PredicateDeclaration::parameters).orElse(List.of());
    for (int i = 0; i < Math.min(parameters.size(), arguments.size()); i++) {
      if (arguments.get(i).equals(new Term.Variable(variable))) {
        parameters.get(i).className().ifPresent(classes::add);
      }
    }
  }

  public Condition condition() {
    return Condition.any(alternatives.stream().map(Alternative::condition).toList());
  }

  GroundGoal simplified(Relevance relevance) {
    return new GroundGoal(
        alternatives.stream()
            .map(a -> new Alternative(a.binding(), relevance.simplified(a.condition())))
            .toList());
  }

  /** The binding of the first alternative that the state fulfils. */
  Map<String, Term> bindingIn(State state) {
    return alternatives.stream()
        .filter(alternative -> alternative.condition().holds(state))
        .findFirst()
        .map(Alternative::binding)
        .orElse(Map.of());
  }
}
