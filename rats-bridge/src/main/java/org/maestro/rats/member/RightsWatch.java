package org.maestro.rats.member;

import java.time.Duration;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.time.Clock;

/**
 * On a secured site, ends what runs or waits for a caller that may not call it any more (ADE, 3.1;
 * A28): a camera does not go on showing pictures to whom it would refuse them now. Clock thread
 * only.
 */
final class RightsWatch {

  /** Simulated time at one second per second; a faster clock looks as often on the wall. */
  private static final Duration LOOK = Duration.ofMillis(500);

  private final String member;
  private final CallPolicy policy;
  private final TaskQueue tasks;
  private final Clock clock;
  private boolean watching;

  RightsWatch(String member, CallPolicy policy, TaskQueue tasks, Clock clock) {
    this.member = member;
    this.policy = policy;
    this.tasks = tasks;
    this.clock = clock;
  }

  /** Something has begun. */
  void begin() {
    if (policy.isSecured() && !watching) {
      watching = true;
      lookLater();
    }
  }

  private void lookLater() {
    Duration pause = clock.ofWall(LOOK);
    clock.schedule(pause, member, this::look);
  }

  private void look() {
    watching = !tasks.isIdle();
    if (watching) {
      tasks.stopForbidden(this::mayCall);
      lookLater();
    }
  }

  private boolean mayCall(Call call) {
    return policy.allows(call.from(), member, call.feature());
  }
}
