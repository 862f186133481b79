package org.maestro.rats.time;

import java.time.Duration;
import java.time.Instant;

/**
 * Simulated time. Any thread may call it. Actions run one at a time on the clock's thread (the paced clock's own, or the one that
 * drives a stepped clock); they must not block.
 */
public interface Clock {

  /** Simulated time since the clock's start. */
  Duration now();

  /** The instant that stands for the start; wall time for a paced clock, a fixed date for a stepped one. */
  Instant start();

  /**
   * Runs the action after the delay of simulated time. Simultaneous actions run in the order of their owner's name, then of
   * the calls.
   *
   * @param owner who the action belongs to: a member's or agent's id
   */
  Timer schedule(Duration delay, String owner, Runnable action);

  /** Keeps a stepped clock from moving until the ticket is closed; costs nothing on a paced one. */
  Ticket hold(String holder);

  default Instant instant() {
    return start().plus(now());
  }

  /** A scheduled action. Cancelling twice, or too late, does nothing. */
  interface Timer {
    void cancel();
  }

  /** Work under way. Closing twice does nothing; any thread may close it. */
  interface Ticket extends AutoCloseable {
    @Override
    void close();
  }
}
