package org.maestro.planning.unsolvable;

import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.concurrent.CancellationException;
import org.maestro.planning.ground.Grounder;
import org.maestro.planning.ground.GroundingBudget;
import org.maestro.planning.ground.LiftedTask;

/** The reasons why a task has no plan. */
public final class Unsolvable {
  private Unsolvable() {}

  /**
   * The reasons, as far as they are found in time and memory: none, where there is more to it.
   *
   * @param task proven to have no plan
   */
  public static List<String> reasons(LiftedTask task, GroundingBudget patience) {
    try {
      patience.refuseIfOver();
      MissingCondition missing = new MissingCondition(task, Grounder.reach(task, patience));
      List<List<String>> ways = task.goals().stream().map(missing::sentences).toList();
      if (ways.stream().noneMatch(List::isEmpty)) {
        return Collections.min(ways, Comparator.comparingInt(List::size));
      }
      return task.goals().size() > 1
          ? List.of()
          : new GoalConflict(task, task.goals().get(0), patience).sentence().stream().toList();
    } catch (CancellationException | OutOfMemoryError e) {
      return List.of();
    }
  }
}
