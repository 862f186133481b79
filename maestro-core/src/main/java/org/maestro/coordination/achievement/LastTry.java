package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.HashMap;
import java.util.HashSet;
import java.util.Map;
import java.util.Set;
import java.util.stream.Collectors;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.knowledge.api.MemberCondition;
import org.maestro.knowledge.api.Source;
import org.maestro.planning.api.StepKey;
import org.maestro.rats.time.Clock;
import org.maestro.sl.SlPrinter;

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

  /** By then a try has led to a plan, or to another pause. */
  private static final Duration TRIED = Duration.ofSeconds(2);

  private static final int MOST_QUESTIONS = 2;

  private final Ports ports;
  private final ActiveGoals activeGoals;
  private final GoalMonitor monitor;
  private final ExactPrices exactPrices;
  private final Map<StepKey, Integer> timesWaitedFor = new HashMap<>();
  private Set<String> waitedFor = Set.of();
  private Clock.Timer forgetting = () -> {};
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
    waitedFor =
        round.task().barred().stream()
            .map(StepKey::member)
            .map(member -> SlPrinter.print(MemberCondition.waitedFor(member)))
            .collect(Collectors.toSet());
    return left;
  }

  /** How long it is waited for the try that is left. */
  Duration pause() {
    return pause;
  }

  /**
   * Until then, and until it has been tried, it is known of those who are waited for, so that rules
   * can do something about it.
   */
  void afterPause(Runnable then) {
    forgetting.cancel();
    Map<String, Double> surely = new HashMap<>();
    waitedFor.forEach(fact -> surely.put(fact, 1.0));
    tellOfWaiting(surely);
    afterwards(pause, () -> activeGoals.run(then));
    forgetting = afterwards(pause.plus(TRIED), () -> tellOfWaiting(Map.of()));
  }

  private void tellOfWaiting(Map<String, Double> facts) {
    ports.knowledge().believe(new Source(Source.Kind.OBSERVED, monitor.goalId()), facts);
  }

  private Clock.Timer afterwards(Duration time, Runnable action) {
    return ports.clock().schedule(time, monitor.goalId(), () -> ports.owner().execute(action));
  }
}
