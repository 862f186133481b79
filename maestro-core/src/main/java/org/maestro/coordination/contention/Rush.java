package org.maestro.coordination.contention;

import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Executor;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;

/**
 * A burst of goals that are stated at once: all of them get a plan before the first step of any is
 * begun, as steps take processors from planning, and change what the plans of the others count on,
 * which are then made in vain. It lasts until all are planned, and a few seconds at most; then it
 * is over until there was a moment without goals to be planned. The coordinator's thread only.
 */
public final class Rush {
  /** So many goals without a plan are common where several people share a home. */
  private static final int FEW = 8;

  private enum Phase {
    CALM,
    RUSH,
    /** Over by its length, while goals are still to be planned. */
    SPENT
  }

  /** Wall time: how fast plans are made does not depend on how fast the world goes. */
  public static final Duration LONGEST = Duration.ofSeconds(5);

  private final Clock clock;
  private final Executor owner;
  private final Consumer<String> goOn;
  private final Set<String> unplanned = new LinkedHashSet<>();
  private final Set<String> heldBack = new LinkedHashSet<>();
  private Clock.Timer limit = () -> {};
  private Phase phase = Phase.CALM;

  /**
   * @param goOn told of each goal that was held back and is not any more
   */
  Rush(Clock clock, Executor owner, Consumer<String> goOn) {
    this.clock = clock;
    this.owner = owner;
    this.goOn = goOn;
  }

  /** The goal's first plan is being made. */
  public void planning(String goal) {
    unplanned.add(goal);
    if (phase == Phase.CALM && unplanned.size() > FEW) {
      phase = Phase.RUSH;
      limit = clock.schedule(clock.ofWallAtLeast(LONGEST), "rush", () -> owner.execute(this::over));
    }
  }

  /** It has a plan, or there is none. */
  public void planned(String goal) {
    if (unplanned.remove(goal) && unplanned.isEmpty()) {
      over();
      phase = Phase.CALM;
    }
  }

  /** Whether nothing is begun for the goal yet; if so, it is told when that is over. */
  public boolean holdsBack(String goal) {
    boolean isHeldBack = phase == Phase.RUSH;
    if (isHeldBack) {
      heldBack.add(goal);
    }
    return isHeldBack;
  }

  private void over() {
    if (phase != Phase.RUSH) {
      return;
    }
    limit.cancel();
    phase = Phase.SPENT;
    List<String> free = new ArrayList<>(heldBack);
    heldBack.clear();
    free.forEach(goOn);
  }
}
