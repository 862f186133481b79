package org.maestro.planning.optimal;

import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.PriorityQueue;
import java.util.Set;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.PlanningResult.Obstacle;
import org.maestro.planning.api.PlanningResult.Obstacle.Extent;
import org.maestro.planning.api.PlanningResult.Obstacle.Kind;
import org.maestro.planning.problem.Condition;
import org.maestro.planning.problem.GroundGoal;
import org.maestro.planning.problem.GroundGoal.Alternative;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.NumberVariable;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;
import org.maestro.planning.settings.SettingAnalysis;
import org.maestro.planning.settings.SettledSums;
import org.maestro.planning.settings.Threshold;
import org.maestro.sl.SlPrinter;

/**
 * The limits to which numbers can be moved by what can be done. All states that matter for a number
 * are tried, the best first; where these are too many, the best is proven only if no settings add
 * up to more.
 */
public final class NumberLimits {
  /** Tried for one number; a state costs no more here than its successors do. */
  private static final int MOST_STATES = 20_000;

  /** Trying an operator takes as long as looking at so many actions of an estimate. */
  private static final long LOOKS_OF_ONE_TRY = 32;

  private final GroundProblem base;
  private final List<Operator> possible;
  private final Effort effort = Effort.forBestPlan(MOST_STATES);

  /** The best that was found, and whether nothing is better. */
  private record Best(double value, boolean proven) {}

  /** A state, and how good it is. */
  private record Entry(State state, double merit, long sequence) {}

  /**
   * @param base with operators that are possible, and others that are not
   * @param possible those operators that nothing forbids
   */
  public NumberLimits(GroundProblem base, List<Operator> possible) {
    this.base = base;
    this.possible = possible;
  }

  /**
   * The obstacle, with the best that can be reached where it is a number that can be moved, and
   * with whether others could find out where it is unknown.
   */
  public Obstacle limited(Obstacle obstacle, Condition leaf) {
    if (obstacle.kind() == Kind.UNKNOWN) {
      return obstacle.with(othersCouldMoveIt(leaf) ? Extent.LIMIT_NOW : Extent.LIMIT);
    }
    if (obstacle.kind() != Kind.NUMBER || !(leaf instanceof Condition.Compare compare)) {
      return obstacle;
    }
    return Threshold.of(compare)
        .map(threshold -> limited(obstacle, leaf, threshold))
        .orElse(obstacle);
  }

  private Obstacle limited(Obstacle obstacle, Condition leaf, Threshold threshold) {
    Best best = best(threshold, problem(leaf, possible));
    return obstacle.with(
        SlPrinter.print(best.value()),
        best.proven() ? othersCouldMoveIt(leaf) ? Extent.LIMIT_NOW : Extent.LIMIT : Extent.FOUND);
  }

  private GroundProblem problem(Condition wanted, List<Operator> operators) {
    GroundGoal goal = new GroundGoal(List.of(new Alternative(Map.of(), wanted)));
    return new GroundProblem(operators, goal, base.variables(), base.numbers(), base.initial())
        .with(operators);
  }

  /** Whether somebody who is not there, or does not do it, might move it further. */
  private boolean othersCouldMoveIt(Condition leaf) {
    return problem(leaf, base.operators()).operators().stream()
        .flatMap(operator -> operator.precondition().conjuncts().stream())
        .anyMatch(
            part ->
                part instanceof Condition.Fixed fixed
                    && (fixed.obstacle().kind() == Kind.MEMBER
                        || fixed.obstacle().kind() == Kind.STEP));
  }

  private Best best(Threshold threshold, GroundProblem problem) {
    NumberVariable variable = threshold.variable();
    double sign = threshold.upward() ? 1 : -1;
    SettingAnalysis settings = new SettingAnalysis(problem);
    double bound =
        settings
            .sum(variable)
            .map(sum -> sign * sum.extreme(problem.initial().numbers(), threshold.upward()))
            .orElse(Double.POSITIVE_INFINITY);
    SettledSums settled = new SettledSums(settings, problem.initial().numbers());
    Set<State> seen = new HashSet<>();
    PriorityQueue<Entry> open =
        new PriorityQueue<>(
            Comparator.comparingDouble(Entry::merit).reversed().thenComparingLong(Entry::sequence));
    double best = sign * variable.initial();
    seen.add(problem.initial());
    open.add(new Entry(problem.initial(), best, 0));
    while (!open.isEmpty() && best < bound) {
      if (seen.size() > effort.mostStates() || effort.isSpent()) {
        return new Best(sign * best, false);
      }
      State from = open.remove().state();
      effort.spend(LOOKS_OF_ONE_TRY * problem.operators().size());
      for (Operator operator : problem.operators()) {
        if (Successors.isApplicable(operator, from)) {
          State after = settled.settled(Successors.after(operator, from));
          double merit = sign * after.number(variable);
          if (!Double.isFinite(merit)) {
            return new Best(sign * best, false);
          }
          if (seen.add(after)) {
            best = Math.max(best, merit);
            open.add(new Entry(after, merit, seen.size()));
          }
        }
      }
    }
    return new Best(sign * best + 0.0, true);
  }
}
