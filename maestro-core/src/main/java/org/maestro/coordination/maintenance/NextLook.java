package org.maestro.coordination.maintenance;

import java.time.Duration;
import org.maestro.coordination.api.Ports;
import org.maestro.rats.time.Clock;

/**
 * The next look at a held goal that nothing else may bring about; an earlier one replaces a later
 * one. The coordinator's thread only.
 */
final class NextLook {
  private final String goalId;
  private final Ports ports;
  private final Runnable look;
  private Clock.Timer timer = () -> {};

  NextLook(String goalId, Ports ports, Runnable look) {
    this.goalId = goalId;
    this.ports = ports;
    this.look = look;
  }

  void in(Duration wait) {
    timer.cancel();
    timer = ports.clock().schedule(wait, goalId, () -> ports.owner().execute(look));
  }

  void cancel() {
    timer.cancel();
  }
}
