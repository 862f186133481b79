package org.maestro.rats.time;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.OptionalLong;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.function.BooleanSupplier;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Time that jumps from event to event. It has no thread: whoever calls {@link #runUntil} drives it
 * and runs the actions. It never moves while a ticket is held. Any thread may schedule, hold and
 * read; order and determinism are described at {@link Clock}.
 */
public final class SteppedClock implements Clock {

  private static final Logger LOG = LoggerFactory.getLogger(SteppedClock.class);
  private static final Instant START = Instant.parse("2026-01-01T00:00:00Z");
  private static final Duration DEFAULT_STALL_LIMIT = Duration.ofSeconds(30);
  private static final int MOST_FRAMES = 20;

  private final Object monitor = new Object();
  private final PriorityQueue<Event> events = new PriorityQueue<>();
  private final Set<HeldTicket> tickets = new LinkedHashSet<>();
  private final Duration stallLimit;
  private final OptionalLong interleaving;
  private volatile Duration now = Duration.ZERO;
  private long nextSequence;
  private @Nullable Thread driver;

  public SteppedClock() {
    this(DEFAULT_STALL_LIMIT);
  }

  /**
   * @param stallLimit wall time that the clock waits for a held ticket before {@link
   *     ClockStalledException}
   */
  public SteppedClock(Duration stallLimit) {
    this(stallLimit, OptionalLong.empty());
  }

  private SteppedClock(Duration stallLimit, OptionalLong interleaving) {
    this.stallLimit = stallLimit;
    this.interleaving = interleaving;
  }

  /**
   * One on which owners take turns at what is due at the same time as chance has it: another order
   * for each seed, and the same for the same one. What one owner has scheduled for one time stays
   * in its order.
   */
  public static SteppedClock shuffled(long seed) {
    return new SteppedClock(DEFAULT_STALL_LIMIT, OptionalLong.of(seed));
  }

  @Override
  public Duration now() {
    return now;
  }

  @Override
  public Instant start() {
    return START;
  }

  @Override
  public boolean isStepped() {
    return true;
  }

  @Override
  public Timer schedule(Duration delay, String owner, Runnable action) {
    synchronized (monitor) {
      Duration due = delay.isNegative() ? now : now.plus(delay);
      Event event = new Event(due, turn(due, owner), nextSequence++, action);
      events.add(event);
      return () -> {
        synchronized (monitor) {
          events.remove(event);
        }
      };
    }
  }

  private long turn(Duration due, String owner) {
    return interleaving.isEmpty()
        ? 0
        : new SplittableRandom(
                interleaving.getAsLong() * 31 * 31 + due.toNanos() * 31 + owner.hashCode())
            .nextLong();
  }

  @Override
  public Ticket hold(String holder) {
    HeldTicket ticket = new HeldTicket(holder);
    synchronized (monitor) {
      tickets.add(ticket);
    }
    return ticket;
  }

  /**
   * Runs events in order until the condition holds or the limit of simulated time has passed; then
   * now is the end of the limit. The condition is read on the calling thread before each event
   * while no ticket is held. What an action throws ends the call; the clock stays usable.
   *
   * @param limit simulated time from now
   * @return whether the condition holds
   * @throws ClockStalledException when a ticket is held for longer than the stall limit of wall
   *     time
   * @throws IllegalStateException when another thread, or an action of this clock, drives it
   *     already
   */
  public boolean runUntil(BooleanSupplier condition, Duration limit) {
    takeTheWheel();
    try {
      Duration end = now.plus(limit);
      while (true) {
        awaitTickets();
        if (condition.getAsBoolean()) {
          return true;
        }
        Event event = nextBefore(end);
        if (event == null) {
          return false;
        }
        event.action.run();
      }
    } finally {
      synchronized (monitor) {
        driver = null;
      }
    }
  }

  /** Lets the given simulated time pass. */
  public void run(Duration duration) {
    runUntil(() -> false, duration);
  }

  private void takeTheWheel() {
    synchronized (monitor) {
      if (driver != null) {
        throw new IllegalStateException(
            "The stepped clock is already driven by the thread " + driver.getName());
      }
      driver = Thread.currentThread();
    }
  }

  private @Nullable Event nextBefore(Duration end) {
    synchronized (monitor) {
      Event event = events.peek();
      if (event == null || event.due.compareTo(end) > 0) {
        now = end;
        return null;
      }
      events.remove();
      now = event.due;
      return event;
    }
  }

  private void awaitTickets() {
    long deadline = System.nanoTime() + stallLimit.toNanos();
    synchronized (monitor) {
      while (!tickets.isEmpty()) {
        long leftMillis = (deadline - System.nanoTime()) / 1_000_000;
        if (leftMillis <= 0) {
          LOG.error("The stepped clock is stalled; what each thread is at:{}", stacks());
          throw new ClockStalledException(now, stallLimit, holders());
        }
        try {
          monitor.wait(leftMillis);
        } catch (InterruptedException interrupted) {
          Thread.currentThread().interrupt();
          throw new IllegalStateException(
              "The thread that drives the stepped clock was interrupted while these held a ticket: "
                  + String.join(", ", holders()),
              interrupted);
        }
      }
    }
  }

  private static String stacks() {
    StringBuilder text = new StringBuilder();
    Thread.getAllStackTraces()
        .forEach(
            (thread, frames) -> {
              text.append("\n").append(thread.getName()).append(", ").append(thread.getState());
              Stream.of(frames).limit(MOST_FRAMES).forEach(at -> text.append("\n  ").append(at));
            });
    return text.toString();
  }

  private List<String> holders() {
    List<String> names = new ArrayList<>();
    tickets.forEach(ticket -> names.add(ticket.holder));
    return names;
  }

  private record Event(Duration due, long turn, long sequence, Runnable action)
      implements Comparable<Event> {

    @Override
    public int compareTo(Event other) {
      int byTime = due.compareTo(other.due);
      int byTurn = byTime != 0 ? byTime : Long.compare(turn, other.turn);
      return byTurn != 0 ? byTurn : Long.compare(sequence, other.sequence);
    }
  }

  private final class HeldTicket implements Ticket {
    private final String holder;

    private HeldTicket(String holder) {
      this.holder = holder;
    }

    @Override
    public void close() {
      synchronized (monitor) {
        if (tickets.remove(this) && tickets.isEmpty()) {
          monitor.notifyAll();
        }
      }
    }
  }
}
