package org.maestro.planning;

import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Variable;

/** What a ground problem says, as lines of text that do not hang on when its variables were met. */
final class DescribedProblem {
  private DescribedProblem() {}

  static List<String> of(GroundProblem problem) {
    GroundProblem placed = problem.placed();
    List<String> lines = new ArrayList<>();
    placed.goal().alternatives().forEach(a -> lines.add(a.binding() + " " + of(a.condition())));
    for (Variable variable : placed.variables()) {
      int code = variable.initialCode();
      lines.add(name(variable) + " " + (code < 0 ? "not known" : variable.value(code)));
    }
    placed.numbers().forEach(n -> lines.add(n.fluent() + " " + n.initial()));
    for (Operator operator : placed.operators()) {
      StringBuilder line = new StringBuilder(operator.key().toString());
      line.append(" at ").append(of(operator.price().cost()));
      line.append(" in ").append(of(operator.price().seconds()));
      line.append(operator.price().exact()).append(" if ").append(of(operator.precondition()));
      operator.changes().forEach(change -> line.append(" then ").append(of(change)));
      lines.add(line.toString());
    }
    return lines;
  }

  private static String name(Variable variable) {
    return variable.predicate() + variable.arguments();
  }

  private static String of(Change change) {
    String what =
        change instanceof Change.OfVariable of
            ? name(of.variable()) + " " + of.variable().value(of.value())
            : ((Change.OfNumber) change).variable().fluent()
                + (change instanceof Change.Adjust adjust
                    ? " " + adjust.assignment() + of(adjust.value())
                    : "");
    return change.getClass().getSimpleName() + " " + what + " when " + of(change.condition());
  }

  private static String of(Condition condition) {
    if (condition instanceof Condition.Literal literal) {
      Variable variable = literal.variable();
      boolean atFirst = literal.holdsFor(variable.initialCode());
      return "%s %s %s, at first %s"
          .formatted(name(variable), literal.question(), variable.value(literal.value()), atFirst);
    } else if (condition instanceof Condition.NumberKnown number) {
      return number.variable().fluent() + " known " + number.known();
    } else if (condition instanceof Condition.Compare compare) {
      return "(%s %s %s %s)"
          .formatted(
              of(compare.left()), compare.relation(), of(compare.right()), compare.positive());
    } else if (condition instanceof Condition.All all) {
      return all.parts().stream().map(DescribedProblem::of).toList().toString();
    } else if (condition instanceof Condition.Any any) {
      return "any of " + any.parts().stream().map(DescribedProblem::of).toList();
    }
    return condition.toString();
  }

  private static String of(NumberExpression expression) {
    if (expression instanceof NumberExpression.Operation operation) {
      return operation.operator()
          + operation.operands().stream().map(DescribedProblem::of).toList().toString();
    }
    List<String> read = new ArrayList<>();
    Consumer<NumberVariable> reader = variable -> read.add(variable.fluent().toString());
    expression.forEachVariable(reader);
    return read.isEmpty() ? expression.toString() : read.toString();
  }
}
