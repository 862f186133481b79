package org.maestro.rats.time;

import java.time.Duration;
import java.time.Instant;

/**
 * Simulated time. Any thread may call it. Actions run one at a time on the clock's thread (the
 * paced clock's own, or the one that drives a stepped clock); they must not block.
 *
 * <p>Simultaneous actions run in the order in which they were scheduled. On a stepped clock that
 * order is the same in every run as long as one rule is kept: <em>an action sets going at most one
 * activity on another thread, and that activity holds a ticket until it is done</em>. The clock
 * runs the next action only when no ticket is held, so there is never more than one logical
 * activity that could schedule anything, and the sequence of the schedule calls follows from the
 * sequence of the actions alone. Whoever has to wake several threads (a message to many receivers)
 * schedules one action for each of them. The order does not look at names, so that renaming a
 * device changes nothing. A stepped clock that is {@linkplain SteppedClock#shuffled shuffled} keeps
 * the order of each owner's simultaneous actions alone.
 */
public interface Clock {

  /** Simulated time since the clock's start. */
  Duration now();

  /**
   * The instant that stands for the start; wall time for a paced clock, a fixed date for a stepped
   * one.
   */
  Instant start();

  /**
   * Runs the action after the delay of simulated time. Simultaneous actions run in the order of
   * these calls.
   *
   * @param delay zero or more; a negative one counts as zero
   * @param owner who the action belongs to, for messages: a member's or agent's id
   */
  Timer schedule(Duration delay, String owner, Runnable action);

  /**
   * The same at once, for what comes from outside the clock: when nothing else is to be done, a
   * paced clock does it on the calling thread, before this returns; that saves a change of threads.
   * To be called where no lock is held.
   */
  default void perform(String owner, Runnable action) {
    schedule(Duration.ZERO, owner, action);
  }

  /** Keeps a stepped clock from moving until the ticket is closed; costs nothing on a paced one. */
  Ticket hold(String holder);

  /**
   * Simulated seconds per second of wall time; 1 on a stepped clock, which has no relation to it.
   */
  default double speed() {
    return 1.0;
  }

  /** As much simulated time as passes in that wall time. */
  default Duration ofWall(Duration wall) {
    return Duration.ofNanos(Math.round(wall.toNanos() * speed()));
  }

  /** The same, and not less than that: what may take long both in the world and on the bus. */
  default Duration ofWallAtLeast(Duration either) {
    Duration simulated = ofWall(either);
    return simulated.compareTo(either) > 0 ? simulated : either;
  }

  /** As much wall time as passes in that simulated time. */
  default Duration toWall(Duration simulated) {
    return Duration.ofNanos(Math.round(simulated.toNanos() / speed()));
  }

  /**
   * Whether time jumps from event to event, so that all work has to be accounted for by tickets.
   */
  default boolean isStepped() {
    return false;
  }

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
