package org.maestro.assembly;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import org.maestro.rats.time.Clock;

/**
 * The clock of a process that may be frozen, as the system's STOP signal does it: time passes, and
 * nothing is done. When it thaws, all that was due meanwhile is done at once, and all that came
 * meanwhile is heard; those who have threads and connections of their own get through with it each
 * in its own time, so that nothing is sure of the order but within one owner. For one thread.
 */
final class FreezableClock implements Clock {
  /** Until everybody is through with what waited. */
  private static final Duration SETTLING = Duration.ofSeconds(1);

  private static final int LONGEST_LAG_MILLIS = 300;

  private final Clock wall;
  private final Random random;
  private final List<Due> waiting = new ArrayList<>();
  private final Map<String, Duration> lags = new TreeMap<>();
  private final Map<String, Duration> lastByOwner = new TreeMap<>();
  private boolean frozen;
  private Duration settled = Duration.ZERO;

  /**
   * @param wall the time that passes
   * @param seed of the order in which what waited is done
   */
  FreezableClock(Clock wall, long seed) {
    this.wall = wall;
    this.random = new Random(seed);
  }

  /** Nothing is done from now on, for so long. */
  void freeze(Duration lasting) {
    frozen = true;
    wall.schedule(lasting, "freeze", this::thaw);
  }

  private void thaw() {
    frozen = false;
    settled = wall.now().plus(SETTLING);
    lags.clear();
    List<Due> overdue = List.copyOf(waiting);
    waiting.clear();
    overdue.forEach(due -> wall.schedule(inTurn(due.owner), due.owner, due::ring));
  }

  /** Who has much to do is late, and keeps its order. */
  private Duration inTurn(String owner) {
    Duration now = wall.now();
    if (now.compareTo(settled) >= 0) {
      return Duration.ZERO;
    }
    Duration lag =
        lags.computeIfAbsent(
            owner, absent -> Duration.ofMillis(random.nextInt(LONGEST_LAG_MILLIS)));
    Duration last = lastByOwner.getOrDefault(owner, Duration.ZERO);
    Duration at = now.plus(lag).compareTo(last) < 0 ? last : now.plus(lag);
    lastByOwner.put(owner, at);
    return at.minus(now);
  }

  @Override
  public Timer schedule(Duration delay, String owner, Runnable action) {
    Due due = new Due(owner, action);
    boolean atOnce = delay.isZero() || delay.isNegative();
    due.timer = wall.schedule(atOnce ? inTurn(owner) : delay, owner, due::ring);
    return due;
  }

  private final class Due implements Timer {
    private final String owner;
    private final Runnable action;
    private Timer timer = () -> {};
    private boolean cancelled;

    private Due(String owner, Runnable action) {
      this.owner = owner;
      this.action = action;
    }

    private void ring() {
      if (frozen) {
        waiting.add(this);
      } else if (!cancelled) {
        action.run();
      }
    }

    @Override
    public void cancel() {
      cancelled = true;
      timer.cancel();
    }
  }

  @Override
  public Duration now() {
    return wall.now();
  }

  @Override
  public Instant start() {
    return wall.start();
  }

  @Override
  public Ticket hold(String holder) {
    return wall.hold(holder);
  }

  @Override
  public double speed() {
    return wall.speed();
  }

  @Override
  public boolean isStepped() {
    return wall.isStepped();
  }
}
