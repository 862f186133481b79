package org.maestro.planning.optimal;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.maestro.planning.problem.ChainCosts;
import org.maestro.planning.problem.GroundProblem;
import org.maestro.planning.problem.Operator;

/**
 * Lower bounds on the cost of plans, by the landmark cuts of the initial state. The cuts leave a
 * rest of each operator's cost, and a plan costs at least the bound and the rests of all that it
 * uses. Where the bound is tight, as it is among many like devices, few operators are of use to
 * plans that cost little more.
 */
public final class CostBounds {
  private static final double ROUNDING = 1e-6;

  private final GroundProblem problem;
  private final LandmarkCut cuts;
  private final double least;
  private final double[] rests;
  private final double[] before;

  /**
   * Operators that a plan within a limit may use.
   *
   * @param beyond what a plan costs at least that uses any other; infinite when there are no others
   */
  public record Useful(List<Operator> operators, double beyond) {}

  /** The problem's variables are placed for it, and have to stay so while it is asked. */
  public CostBounds(GroundProblem problem, RelaxedProblem relaxed) {
    this.problem = problem.placed();
    this.cuts = new LandmarkCut(relaxed);
    this.least = cuts.estimate(problem.initial());
    this.rests = cuts.rests();
    this.before = cuts.restsBefore();
  }

  /** What any plan costs at least; infinite when there is none. */
  public double least() {
    return least;
  }

  /** The cuts, ready for other states. */
  LandmarkCut cuts() {
    return cuts;
  }

  /** Of each of the problem's operators what a plan costs at least that uses it. */
  double[] costsWith() {
    Map<Operator, Double> restOf = new HashMap<>();
    for (int i = 0; i < rests.length; i++) {
      restOf.put(problem.operators().get(i), rests[i]);
    }
    ChainCosts chains = problem.chains(restOf::get, Double.POSITIVE_INFINITY);
    double[] costs = new double[rests.length];
    Arrays.setAll(costs, i -> least + before[i] + chains.of(problem.operators().get(i)));
    return costs;
  }

  public Useful useful(double limit) {
    double most = limit - least + ROUNDING;
    Map<Operator, Double> restOf = new HashMap<>();
    for (int i = 0; i < rests.length; i++) {
      restOf.put(problem.operators().get(i), rests[i]);
    }
    ChainCosts chains = problem.chains(restOf::get, most);
    List<Operator> useful = new ArrayList<>();
    double beyond = chains.beyond();
    for (int i = 0; i < rests.length; i++) {
      Operator operator = problem.operators().get(i);
      double more = before[i] + chains.of(operator);
      if (more <= most) {
        useful.add(operator);
      } else {
        beyond = Math.min(beyond, more);
      }
    }
    return new Useful(useful, least + beyond);
  }
}
