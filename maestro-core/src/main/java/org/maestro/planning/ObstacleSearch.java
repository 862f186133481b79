package org.maestro.planning;

import java.util.List;
import org.maestro.planning.PlanningResult.Explanation;
import org.maestro.planning.PlanningResult.Obstacle;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;

/** Finds what stands in the way of a goal. */
final class ObstacleSearch {
  private ObstacleSearch() {}

  static Explanation explanation(RelaxedProblem relaxed, Formula goal) {
    return exhausted(goal, 0);
  }

  /** For when every condition can be met, but never all that are needed together. */
  static Explanation exhausted(Formula goal, int states) {
    return new Explanation(
        List.of(
            new Obstacle(
                SlPrinter.print(goal),
                "true",
                "none of the " + states + " situations that can be reached fulfils it",
                "the goal")));
  }
}
