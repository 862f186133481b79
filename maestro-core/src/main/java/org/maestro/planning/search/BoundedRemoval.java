package org.maestro.planning.search;

import java.util.ArrayList;
import java.util.List;
import org.maestro.planning.ground.GroundOperator;
import org.maestro.planning.ground.GroundTask;
import org.maestro.planning.ground.GroundingBudget;

/**
 * Removes operators that no plan cheaper than one that is known can have: the lower bound of all
 * plans, with the rests of costs that its cuts left before the operator and for it, reaches the
 * known cost. What then nothing needs any more goes too, to a fixpoint.
 */
final class BoundedRemoval {
  private BoundedRemoval() {}

  /**
   * @param task a task without superfluous operators
   * @param lowerBound no plan of the task costs less
   */
  record Result(GroundTask task, long lowerBound) {}

  /**
   * Removes what cannot be in a plan below a cost.
   *
   * @param below every plan that costs less than this keeps its operators
   * @throws java.util.concurrent.CancellationException when patience is over
   */
  static Result remove(GroundTask task, long below, GroundingBudget patience) {
    GroundTask now = Reduction.reduced(task, patience);
    long bound = 0;
    while (true) {
      SearchTask search = new SearchTask(now, now.operators(), patience);
      LandmarkCuts cuts = new LandmarkCuts(search, search.cost, patience);
      long estimate = cuts.estimate(search.initial);
      bound = Math.max(bound, estimate);
      if (estimate >= below) {
        return new Result(now.withOperators(List.of()), below);
      }
      List<GroundOperator> kept = new ArrayList<>();
      for (int o = 0; o < search.cost.length; o++) {
        long before = cuts.restBefore(o);
        if (before < LandmarkCuts.INFINITE && estimate + before + cuts.rest(o) < below) {
          kept.add(now.operators().get(o));
        }
      }
      if (kept.size() == now.operators().size()) {
        return new Result(now, bound);
      }
      now = Reduction.reduced(now.withOperators(kept), patience);
    }
  }
}
