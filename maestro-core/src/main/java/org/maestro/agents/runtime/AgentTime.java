package org.maestro.agents.runtime;

import java.time.Duration;
import java.util.Optional;
import org.maestro.agents.stepping.SteppedMail;
import org.maestro.rats.time.Clock;

/**
 * The time in which the agents of one platform live: their clock, and how long they wait.
 *
 * @param mail what carries their messages on a stepped clock; empty on a paced one, where JADE does
 */
public record AgentTime(Clock clock, Optional<SteppedMail> mail, ProtocolTimeouts patience) {

  public static AgentTime of(Clock clock) {
    return of(clock, ProtocolTimeouts.standard());
  }

  public static AgentTime of(Clock clock, ProtocolTimeouts patience) {
    return new AgentTime(
        clock,
        clock.isStepped() ? Optional.of(new SteppedMail(clock)) : Optional.empty(),
        patience);
  }

  /** So much wall time, as simulated time; on a stepped clock they are the same. */
  Duration simulated(Duration wallTime) {
    return clock.ofWall(wallTime);
  }

  /** The opposite of {@link #simulated(Duration)}. */
  Duration wallTime(Duration simulated) {
    return clock.toWall(simulated);
  }
}
