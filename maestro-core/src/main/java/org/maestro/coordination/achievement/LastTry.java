package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.planning.api.StepKey;

/**
 * The retries that are left to a goal when there seems to be no plan. A step that failed, or for
 * which its member named no price, may be possible a moment later: what stands in a way drives on.
 * So nothing is given up because of such a step before it was waited for a while and tried once
 * more; where only a price was declined, twice, the second time after a longer while. The
 * coordinator's thread only.
 */
final class LastTry {
  /** In this time a robot has left a doorway. */
  static final Duration PAUSE = Duration.ofSeconds(5);

  private static final int MOST_QUESTIONS = 2;

  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final GoalMonitor monitor;
  private final ExactPrices exactPrices;
  private final Map<StepKey, Integer> timesWaitedFor = new HashMap<>();
  private Duration pause = PAUSE;

  LastTry(Ports ports, ActiveGoals activeGoals, GoalMonitor monitor, ExactPrices exactPrices) {
    this.ports = ports;
    this.activeGoals = activeGoals;
    this.monitor = monitor;
    this.exactPrices = exactPrices;
  }

  /** Whether a step was ruled out that has a try left; it has one less from now on. */
  boolean isLeft(PlanningRound.Ended round) {
    Set<StepKey> notPriced = new HashSet<>(round.task().barred());
    notPriced.removeAll(monitor.barred().keySet());
    Set<StepKey> unanswered = exactPrices.unusable(ports.clock().now());
    boolean left = monitor.lessons().giveLastChances();
    int times = left ? 0 : MOST_QUESTIONS;
    for (StepKey step : notPriced) {
      int before = timesWaitedFor.merge(step, 1, Integer::sum) - 1;
      if (before < (unanswered.contains(step) ? 1 : MOST_QUESTIONS)) {
        left = true;
        times = Math.min(times, before);
      }
    }
    pause = PAUSE.multipliedBy(times + 1L);
    return left;
  }

  /** How long it is waited for the try that is left. */
  Duration pause() {
    return pause;
  }

  void afterPause(Runnable then) {
    ports
        .clock()
        .schedule(
            pause, monitor.goalId(), () -> ports.owner().execute(() -> activeGoals.run(then)));
  }
}
