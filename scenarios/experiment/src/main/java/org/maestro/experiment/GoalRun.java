package org.maestro.experiment;

import java.util.List;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.experiment.measuring.Share;
import org.maestro.experiment.measuring.Spread;
import org.maestro.experiment.measuring.Table;
import org.maestro.experiment.running.Ending;

/** A run in which one goal was stated, and what tables and figures tell of many such runs. */
interface GoalRun {

  /** From 1. */
  int number();

  long seed();

  String goal();

  Ending ending();

  /** In the simulated world. */
  boolean success();

  double seconds();

  /** Nobody could do it in less; NaN where no bound was reckoned. */
  default double boundSeconds() {
    return Double.NaN;
  }

  /** The platform said that it was done, and it was not. */
  default boolean falseClaim() {
    return ending().claimed() && !success();
  }

  /** Why it is not so; empty when it is. */
  String failure();

  static Share reached(List<? extends GoalRun> runs) {
    return new Share((int) runs.stream().filter(GoalRun::success).count(), runs.size());
  }

  static long falseClaims(List<? extends GoalRun> runs) {
    return runs.stream().filter(GoalRun::falseClaim).count();
  }

  /** How many were reached, were not, and were claimed to be reached though they were not. */
  static List<Integer> counts(List<? extends GoalRun> runs) {
    int reached = reached(runs).hits();
    int falselyClaimed = (int) falseClaims(runs);
    return List.of(reached, runs.size() - reached - falselyClaimed, falselyClaimed);
  }

  /** Of runs that were reached. */
  static Spread times(List<? extends GoalRun> runs) {
    return Spread.of(
        runs.stream().filter(GoalRun::success).mapToDouble(GoalRun::seconds).toArray());
  }

  static Table table(List<? extends GoalRun> runs) {
    Table table =
        new Table(
            "run", "seed", "goal", "success", "duration_s", "lower_bound_s", "replans", "failure");
    runs.forEach(
        run ->
            table.add(
                run.number(),
                run.seed(),
                run.goal(),
                run.success(),
                run.seconds(),
                run.boundSeconds(),
                run.ending().replans(),
                run.failure()));
    return table;
  }

  static Table story(List<? extends GoalRun> runs) {
    Table table = new Table("run", "t_s", "kind", "text");
    for (GoalRun run : runs) {
      for (StoryEntry entry : run.ending().story()) {
        table.add(
            run.number(),
            entry.at().minus(run.ending().begun()).toMillis() / 1e3,
            entry.kind(),
            entry.text());
      }
    }
    return table;
  }
}
