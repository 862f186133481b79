package org.maestro.planning;

import java.util.List;
import java.util.Optional;
import org.maestro.planning.cases.GroundTaskCompiler;
import org.maestro.planning.cases.NotCarriedException;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.optimal.OptimalSearch.Outcome;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;
import org.maestro.planning.problem.State;
import org.maestro.planning.problem.Successors;
import org.maestro.planning.search.AnytimePlanner;
import org.maestro.planning.search.Solution;

/**
 * The search for the cheapest plan of a home's problem by the planner over ground tasks, which
 * prices where each robot is and what each lamp is at instead of enumerating them together. Equal
 * problems end the same way on any machine.
 */
final class SearchOverCases {
  /** States of one search, each times the operators that an estimate looks at: about a second. */
  private static final long MOST_WORK = 1_000_000;

  private static final long MOST_BYTES = 100_000_000;
  private static final double ROUNDING = 1e-6;

  private final GroundProblem problem;
  private final int mostStates;

  /**
   * @param mostStates kept at once
   */
  SearchOverCases(GroundProblem problem, int mostStates) {
    this.problem = problem;
    this.mostStates = mostStates;
  }

  /**
   * The outcome; {@link Outcome.BoundReached} where there is neither plan nor proof, or the problem
   * cannot be told in cases. The problem's variables are placed for it.
   *
   * @param mostCost that a plan may have; may be infinite
   */
  Outcome run(double mostCost) {
    GroundTask task;
    try {
      task = GroundTaskCompiler.compile(problem);
    } catch (NotCarriedException e) {
      return new Outcome.BoundReached(0);
    }
    Solution solution =
        new AnytimePlanner(task, MOST_BYTES, line -> {}).within(MOST_WORK, mostStates);
    double unit = task.unit().doubleValue();
    if (solution.verdict() == Solution.Verdict.UNSOLVABLE) {
      return new Outcome.Exhausted(0);
    }
    double cost = solution.cost() / unit;
    return steps(solution, cost)
        .<Outcome>map(
            steps -> {
              if (solution.verdict() != Solution.Verdict.OPTIMAL) {
                return new Outcome.Unproven(steps);
              }
              return cost > mostCost + ROUNDING
                  ? new Outcome.TooDear(cost)
                  : new Outcome.Found(steps);
            })
        .orElseGet(() -> new Outcome.BoundReached(0));
  }

  /** The steps of a plan, if it is one here too, and costs here what it costs there. */
  private Optional<List<Operator>> steps(Solution solution, double expectedCost) {
    if (!solution.hasPlan()) {
      return Optional.empty();
    }
    List<Operator> steps =
        solution.operators().stream()
            .map(GroundOperator::schema)
            .filter(number -> number < problem.operators().size())
            .map(number -> problem.operators().get(number))
            .toList();
    State state = problem.initial();
    double cost = 0;
    for (Operator step : steps) {
      if (!Successors.isApplicable(step, state)) {
        return Optional.empty();
      }
      cost += step.price().cost(state.numbers());
      state = Successors.after(step, state);
    }
    return problem.goal().condition().holds(state) && Math.abs(cost - expectedCost) <= ROUNDING
        ? Optional.of(steps)
        : Optional.empty();
  }
}
