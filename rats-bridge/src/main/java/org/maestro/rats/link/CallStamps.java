package org.maestro.rats.link;

import java.time.Duration;
import org.maestro.rats.protocol.Call;
import org.maestro.rats.protocol.ErrorCode;
import org.maestro.rats.protocol.Result;
import org.maestro.rats.time.Clock;

/** Timestamps of calls, by a clock of the caller's own. Clock thread only. */
final class CallStamps {
  private final Clock clock;
  private final String name;
  private int clocks;

  CallStamps(Clock clock) {
    this.clock = clock;
    this.name = Long.toString(clock.instant().toEpochMilli(), Character.MAX_RADIX);
  }

  /** Of wall time, as members' clocks may run at another speed. */
  Call stamp(Call call) {
    long millis = clock.toWall(clock.now()).toMillis();
    return call.madeAt(new Call.Sent(name + "-" + clocks, millis));
  }

  /**
   * A member that takes for late what cannot have been late has been misled by a clock that stood
   * still for a while, such as one of a machine that slept: from now on it is another clock.
   */
  void check(Duration deadline, Result result) {
    boolean tooLate = result.error().filter(error -> error.code() == ErrorCode.EXPIRED).isPresent();
    if (tooLate && clock.now().compareTo(deadline) < 0) {
      clocks++;
    }
  }
}
