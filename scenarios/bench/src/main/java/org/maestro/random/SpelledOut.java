package org.maestro.random;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;
import org.maestro.ontology.home.Home;
import org.maestro.ontology.home.Individual;
import org.maestro.ontology.vocabulary.PredicateDeclaration;
import org.maestro.sl.Formula;
import org.maestro.sl.FreeVariables;
import org.maestro.sl.Leaves;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;
import org.maestro.sl.TypedVariable;

/** Goals without quantifiers and variables: each individual of the home takes its turn. */
final class SpelledOut {
  private final Home home;

  SpelledOut(Home home) {
    this.home = home;
  }

  /** The same as a formula of atoms and comparisons that name everything. */
  Formula of(Formula goal) {
    Formula bound = goal;
    for (String variable : new TreeSet<>(FreeVariables.of(goal))) {
      bound =
          new Formula.Exists(
              List.of(new TypedVariable(variable, className(goal, variable))), bound);
    }
    return closed(bound);
  }

  private Formula closed(Formula formula) {
    if (formula instanceof Formula.And and) {
      return new Formula.And(and.operands().stream().map(this::closed).toList());
    } else if (formula instanceof Formula.Or or) {
      return new Formula.Or(or.operands().stream().map(this::closed).toList());
    } else if (formula instanceof Formula.Not not) {
      return new Formula.Not(closed(not.operand()));
    } else if (formula instanceof Formula.Keep keep) {
      return closed(keep.body());
    } else if (formula instanceof Formula.Exists exists) {
      return new Formula.Or(instances(exists.variables(), exists.body()));
    } else if (formula instanceof Formula.Forall forall) {
      return new Formula.And(instances(forall.variables(), forall.body()));
    }
    return formula;
  }

  private List<Formula> instances(List<TypedVariable> variables, Formula body) {
    if (variables.isEmpty()) {
      return List.of(closed(body));
    }
    List<Formula> all = new ArrayList<>();
    TypedVariable first = variables.get(0);
    for (Individual individual : home.individuals().values()) {
      if (first.className().isEmpty() || individual.classes().contains(first.className().get())) {
        Formula bound =
            new Substitution(Map.of(first.name(), new Term.Name(individual.name()))).apply(body);
        all.addAll(instances(variables.subList(1, variables.size()), bound));
      }
    }
    return all;
  }

  /** Of what the predicate in which the variable stands takes. */
  private Optional<String> className(Formula goal, String variable) {
    List<String> names = new ArrayList<>();
    Leaves.of(
        goal,
        atom -> {
          Optional<PredicateDeclaration> declared = home.vocabulary().predicate(atom.predicate());
          for (int i = 0; declared.isPresent() && i < atom.arguments().size(); i++) {
            if (atom.arguments().get(i).equals(new Term.Variable(variable))) {
              declared.get().parameters().get(i).className().ifPresent(names::add);
            }
          }
        },
        fluent -> {});
    return names.stream().findFirst();
  }

  /** The alternatives of a formula that is spelled out: in each, all parts have to be so. */
  static List<List<Formula>> cases(Formula formula) {
    if (formula instanceof Formula.Or or) {
      return or.operands().stream().flatMap(operand -> cases(operand).stream()).toList();
    }
    if (formula instanceof Formula.And and) {
      List<List<Formula>> all = List.of(List.of());
      for (Formula operand : and.operands()) {
        List<List<Formula>> longer = new ArrayList<>();
        for (List<Formula> former : all) {
          for (List<Formula> further : cases(operand)) {
            List<Formula> both = new ArrayList<>(former);
            both.addAll(further);
            longer.add(both);
          }
        }
        all = longer;
      }
      return all;
    }
    return List.of(List.of(formula));
  }
}
