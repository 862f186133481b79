package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import org.maestro.planning.api.Objective;
import org.maestro.planning.problem.Change;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberExpression;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.Quantity;
import org.maestro.sl.Effect.Assignment;

/**
 * Makes a ground problem smaller without losing its cheapest plan: drops operators and changes that
 * can never come about, and operators for which another one does the same at no higher price under
 * no stronger condition.
 */
public final class Pruning {
  private Pruning() {}

  /**
   * The problem that is left after pruning.
   *
   * @param relaxed of the problem, and unsolvable where that shows that there is no plan
   */
  public record Pruned(GroundProblem problem, RelaxedProblem relaxed) {
    public boolean isSolvable() {
      return relaxed.isSolvable();
    }
  }

  /** For the cheapest plan. */
  public static Pruned pruned(GroundProblem problem) {
    return pruned(problem, Objective.CHEAPEST);
  }

  /** Where time counts, an operator may do the same at a higher price and sooner. */
  public static Pruned pruned(GroundProblem problem, Objective objective) {
    Pruned before = new Pruned(problem.placed(), new RelaxedProblem(problem));
    while (before.isSolvable()) {
      List<Operator> possible = reachable(before);
      GroundProblem after =
          before
              .problem()
              .with(objective == Objective.CHEAPEST ? withoutDominated(possible) : possible);
      if (size(after) == size(before.problem())) {
        before.problem().placed();
        return before;
      }
      before = new Pruned(after, new RelaxedProblem(after));
    }
    return before;
  }

  private static long size(GroundProblem problem) {
    return problem.operators().stream().mapToLong(o -> 1 + o.changes().size()).sum()
        + problem.variables().size()
        + problem.numbers().size();
  }

  private static List<Operator> reachable(Pruned pruned) {
    GroundProblem problem = pruned.problem();
    Set<Condition> unreachable = pruned.relaxed().unreachableLeaves();
    Set<NumberVariable> assigned = new LinkedHashSet<>();
    for (Operator operator : problem.operators()) {
      for (Change change : operator.changes()) {
        if (change instanceof Change.Adjust adjust && adjust.assignment() == Assignment.ASSIGN) {
          assigned.add(adjust.variable());
        }
      }
    }
    List<Operator> kept = new ArrayList<>();
    for (Operator operator : problem.operators()) {
      if (isPossible(operator.precondition(), unreachable)) {
        List<Change> changes =
            operator.changes().stream()
                .filter(change -> isPossible(change.condition(), unreachable))
                .filter(change -> mayChange(change, unreachable, assigned))
                .toList();
        if (!changes.isEmpty()) {
          kept.add(operator.withChanges(changes));
        }
      }
    }
    return kept;
  }

  private static boolean isPossible(Condition condition, Set<Condition> unreachable) {
    if (condition instanceof Condition.All all) {
      return all.parts().stream().allMatch(part -> isPossible(part, unreachable));
    } else if (condition instanceof Condition.Any any) {
      return any.parts().stream().anyMatch(part -> isPossible(part, unreachable));
    }
    return !unreachable.contains(condition);
  }

  /** Sensing needs something unknown; an unknown number is not moved by adding to it. */
  private static boolean mayChange(
      Change change, Set<Condition> unreachable, Set<NumberVariable> assigned) {
    if (change instanceof Change.Find find) {
      return !unreachable.contains(
          new Condition.Literal(find.variable(), find.value(), Condition.Question.UNKNOWN));
    } else if (change instanceof Change.Measure measure) {
      return !unreachable.contains(new Condition.NumberKnown(measure.variable(), false));
    }
    return !(change instanceof Change.Adjust adjust
        && adjust.assignment() != Assignment.ASSIGN
        && Quantity.isUnknown(adjust.variable().initial())
        && !assigned.contains(adjust.variable()));
  }

  private static List<Operator> withoutDominated(List<Operator> operators) {
    Map<List<Change>, List<Operator>> alike = new LinkedHashMap<>();
    for (Operator operator : operators) {
      List<Operator> kept = alike.computeIfAbsent(operator.changes(), absent -> new ArrayList<>());
      if (kept.stream().noneMatch(other -> dominates(other, operator))) {
        kept.removeIf(other -> dominates(operator, other));
        kept.add(operator);
      }
    }
    Set<Operator> kept = new LinkedHashSet<>();
    alike.values().forEach(kept::addAll);
    return operators.stream().filter(kept::contains).toList();
  }

  private static boolean dominates(Operator better, Operator worse) {
    boolean cheaper =
        better.price().cost() instanceof NumberExpression.Constant a
                && worse.price().cost() instanceof NumberExpression.Constant b
            ? a.number() <= b.number()
            : better.price().cost().equals(worse.price().cost());
    return cheaper
        && worse.precondition().conjuncts().containsAll(better.precondition().conjuncts());
  }
}
