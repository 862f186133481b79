package org.maestro.rats.time;

import java.time.Duration;
import java.time.Instant;
import java.util.concurrent.ScheduledThreadPoolExecutor;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Wall time times a speed. Actions run one at a time, on one daemon thread or, when they come from
 * outside while nothing else is to be done, on the thread that brings them; what they throw goes to
 * the log and the clock goes on. After {@link #close} nothing runs any more and scheduling does
 * nothing.
 */
public final class PacedClock implements Clock, AutoCloseable {

  private static final Logger LOG = LoggerFactory.getLogger(PacedClock.class);
  private static final Timer NOTHING_TO_CANCEL = () -> {};
  private static final Ticket FREE_TICKET = () -> {};

  private final double speed;
  private final Instant start = Instant.now();
  private final long startNanos = System.nanoTime();
  private final ScheduledThreadPoolExecutor executor;
  private final Turns turns;
  private final Alarms alarms;

  /**
   * @param speed simulated seconds per second of wall time, above 0
   */
  public PacedClock(double speed) {
    if (!(speed > 0) || Double.isInfinite(speed)) {
      throw new IllegalArgumentException(
          "The speed of a paced clock must be a number above 0, not " + speed);
    }
    this.speed = speed;
    this.executor =
        new ScheduledThreadPoolExecutor(
            1,
            runnable -> {
              Thread thread = new Thread(runnable, "maestro-clock");
              thread.setDaemon(true);
              return thread;
            },
            (task, stopped) -> LOG.debug("The clock is closed: an action is dropped"));
    executor.setRemoveOnCancelPolicy(true);
    executor.setExecuteExistingDelayedTasksAfterShutdownPolicy(false);
    this.turns = new Turns(executor);
    this.alarms = new Alarms(executor, turns::doOrAdd, System::nanoTime);
  }

  @Override
  public Duration now() {
    return Duration.ofNanos(Math.round((System.nanoTime() - startNanos) * speed));
  }

  @Override
  public Instant start() {
    return start;
  }

  @Override
  public double speed() {
    return speed;
  }

  @Override
  public Timer schedule(Duration delay, String owner, Runnable action) {
    if (executor.isShutdown()) {
      return NOTHING_TO_CANCEL;
    }
    if (delay.isNegative() || delay.isZero()) {
      Due due = new Due(owner, action);
      turns.add(due);
      return due;
    }
    Due due = new Due(owner, action);
    Timer alarm = alarms.add(Math.round(delay.toNanos() / speed), due);
    return () -> {
      alarm.cancel();
      due.cancel();
    };
  }

  @Override
  public void perform(String owner, Runnable action) {
    if (!executor.isShutdown()) {
      turns.doOrAdd(new Due(owner, action));
    }
  }

  @Override
  public Ticket hold(String holder) {
    return FREE_TICKET;
  }

  @Override
  public void close() {
    executor.shutdownNow();
  }

  /** An action whose time has come, unless it is cancelled before its turn does. */
  private final class Due implements Runnable, Timer {
    private final String owner;
    private final Runnable action;
    private volatile boolean cancelled;

    private Due(String owner, Runnable action) {
      this.owner = owner;
      this.action = action;
    }

    @Override
    public void cancel() {
      cancelled = true;
    }

    @Override
    public void run() {
      if (cancelled || executor.isShutdown()) {
        return;
      }
      try {
        action.run();
      } catch (RuntimeException | Error failure) {
        LOG.error("An action of {} failed; the clock goes on", owner, failure);
      }
    }
  }
}
