package org.maestro.planning;

import java.util.Collection;
import java.util.List;
import java.util.OptionalDouble;
import org.maestro.planning.api.PlanningTask;
import org.maestro.planning.api.Step;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Quantity;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;
import org.maestro.planning.problem.Variable;
import org.maestro.sl.Expression;
import org.maestro.sl.Facts;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/** What is known after steps that did what was expected of them; measured is a certain number. */
record FactsAfter(Facts before, GroundProblem problem, State state) implements Facts {
  private static final double MEASURED = 55;

  /** After the first steps of a plan. */
  static FactsAfter steps(PlanningTask task, List<Step> steps) {
    GroundProblem everything = Everything.ground(task);
    State state = everything.initial();
    for (Step step : steps) {
      State now = state;
      Operator operator =
          everything.operators().stream()
              .filter(o -> o.key().equals(step.key()) && Successors.isApplicable(o, now))
              .findFirst()
              .orElseThrow();
      state = Successors.after(operator, now);
    }
    return new FactsAfter(task.facts(), everything, state);
  }

  @Override
  public Truth truth(Formula.Atom atom) {
    for (Variable variable : problem.placed().variables()) {
      if (!variable.predicate().equals(atom.predicate())) {
        continue;
      }
      int arguments = variable.arguments().size();
      if (!variable.functional() && isThis(variable, atom.arguments())) {
        return truth(variable, 0);
      }
      if (variable.functional()
          && atom.arguments().size() == arguments + 1
          && atom.arguments().subList(0, arguments).equals(variable.arguments())) {
        return truth(variable, variable.indexOf(atom.arguments().get(arguments)));
      }
    }
    return before.truth(atom);
  }

  private static boolean isThis(Variable variable, List<Term> arguments) {
    return arguments.equals(variable.arguments())
        || arguments.size() == 2
            && variable.predicate().equals("nextTo")
            && List.of(arguments.get(1), arguments.get(0)).equals(variable.arguments());
  }

  private Truth truth(Variable variable, int value) {
    int code = state.code(variable);
    if (code == value) {
      return Truth.TRUE;
    }
    return variable.isUnknown(code, value) ? Truth.UNKNOWN : Truth.FALSE;
  }

  @Override
  public OptionalDouble number(Expression.Fluent fluent) {
    for (NumberVariable variable : problem.placed().numbers()) {
      if (variable.fluent().equals(fluent)) {
        double number = state.number(variable);
        return Quantity.isUnknown(number)
            ? OptionalDouble.empty()
            : OptionalDouble.of(Quantity.isAny(number) ? MEASURED : number);
      }
    }
    return before.number(fluent);
  }

  @Override
  public Collection<Term.Name> individuals(String className) {
    return before.individuals(className);
  }
}
