package org.maestro.planning.optimal;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.maestro.planning.api.Effort;
import org.maestro.planning.api.StepKey;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;

/**
 * A* under a limit that grows from the lower bound of the initial state, each time over the few
 * operators that are of use within it.
 */
public final class LimitedSearch {
  /** Of the limit's distance from the bound, from one search to the next. */
  private static final double GROWTH = 2;

  /** Of the bound: by so much the limit grows at first, at least. */
  private static final double FIRST_STEP = 0.02;

  /** Then all operators are taken. */
  private static final int MOST_ROUNDS = 8;

  private static final double ROUNDING = 1e-6;

  private final GroundProblem problem;
  private final RelaxedProblem relaxed;
  private final Effort effort;
  private final double mostCost;

  /**
   * @param relaxed of that problem
   * @param effort that it may cost
   * @param mostCost that a plan may have; may be infinite
   */
  public LimitedSearch(
      GroundProblem problem, RelaxedProblem relaxed, Effort effort, double mostCost) {
    this.problem = problem;
    this.relaxed = relaxed;
    this.effort = effort;
    this.mostCost = mostCost;
  }

  /** The operators found are those of the given problem, whose variables are placed for it. */
  public OptimalSearch.Outcome run() {
    CostBounds bounds = new CostBounds(problem, relaxed);
    if (bounds.least() == Double.POSITIVE_INFINITY) {
      return new OptimalSearch.Outcome.Exhausted(1);
    }
    double limit = bounds.least();
    for (int round = 1; limit <= mostCost + ROUNDING; round++) {
      CostBounds.Useful useful = bounds.useful(limit);
      if (round > MOST_ROUNDS || useful.beyond() == Double.POSITIVE_INFINITY) {
        return new OptimalSearch(problem, bounds.cuts(), effort, mostCost).run();
      }
      OptimalSearch.Outcome outcome = among(useful.operators(), limit + ROUNDING);
      problem.placed();
      if (outcome instanceof OptimalSearch.Outcome.Found
          || outcome instanceof OptimalSearch.Outcome.BoundReached) {
        return outcome;
      }
      double next =
          outcome instanceof OptimalSearch.Outcome.TooDear dear
              ? Math.min(dear.atLeast(), useful.beyond())
              : useful.beyond();
      if (next > mostCost + ROUNDING) {
        return new OptimalSearch.Outcome.TooDear(next);
      }
      double step = Math.max(GROWTH * (limit - bounds.least()), FIRST_STEP * bounds.least());
      limit = Math.max(next, Math.min(bounds.least() + step, mostCost));
    }
    return new OptimalSearch.Outcome.TooDear(limit);
  }

  private OptimalSearch.Outcome among(List<Operator> useful, double limit) {
    GroundProblem smaller = problem.with(useful);
    RelaxedProblem relaxation = new RelaxedProblem(smaller);
    if (!relaxation.isSolvable()) {
      return new OptimalSearch.Outcome.Exhausted(1);
    }
    OptimalSearch.Outcome outcome =
        new OptimalSearch(smaller, new LandmarkCut(relaxation), effort, limit).run();
    if (outcome instanceof OptimalSearch.Outcome.Found found) {
      Map<StepKey, Operator> original = new HashMap<>();
      useful.forEach(operator -> original.put(operator.key(), operator));
      return new OptimalSearch.Outcome.Found(
          found.operators().stream().map(step -> original.get(step.key())).toList());
    }
    return outcome;
  }
}
