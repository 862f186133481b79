package org.maestro.coordination;

import java.time.Duration;
import java.util.HashSet;
import java.util.Set;
import org.maestro.planning.StepKey;

/**
 * What is left to be tried when there seems to be no plan. A step that failed, or for which its
 * member named no price, may be possible a moment later: what stands in a way drives on. So nothing
 * is called impossible because of such a step before it was waited for a while and tried once more.
 * The coordinator's thread only.
 */
final class LastTry {
  /** In this time a robot has left a doorway. */
  static final Duration PAUSE = Duration.ofSeconds(5);

  private final Ports ports;
  private final Rivals rivals;
  private final Outlook outlook;
  private final Set<StepKey> waitedFor = new HashSet<>();

  LastTry(Ports ports, Rivals rivals, Outlook outlook) {
    this.ports = ports;
    this.rivals = rivals;
    this.outlook = outlook;
  }

  /** Whether a step was ruled out that had no last try yet; it has one from now on. */
  boolean isLeft(PlanningRound.Ended round) {
    Set<StepKey> notPriced = new HashSet<>(round.task().barred());
    notPriced.removeAll(outlook.barred().keySet());
    boolean priced = !waitedFor.addAll(notPriced);
    return outlook.giveLastChances() || !priced;
  }

  void afterPause(Runnable then) {
    ports
        .clock()
        .schedule(
            PAUSE,
            outlook.goalId(),
            () -> ports.thinking().think(outlook::goalId, due -> rivals.run(then)));
  }
}
