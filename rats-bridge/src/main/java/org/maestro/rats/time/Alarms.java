package org.maestro.rats.time;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.NavigableSet;
import java.util.Optional;
import java.util.TreeSet;
import java.util.concurrent.Future;
import java.util.concurrent.ScheduledExecutorService;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.function.LongSupplier;

/**
 * Actions for later, in the order of their times. Most are time limits that are cancelled long
 * before, and to wake a thread takes longer than to set one: so the thread is woken only for what
 * comes before all that it waits for already. Any thread.
 */
final class Alarms {

  /** So that sums of times stay far from the largest number. */
  private static final long LONGEST_NANOS = Long.MAX_VALUE / 4;

  private final ScheduledExecutorService thread;
  private final Consumer<Runnable> due;
  private final NavigableSet<Alarm> open =
      new TreeSet<>(Comparator.comparingLong(Alarm::atNanos).thenComparingLong(Alarm::number));
  private final LongSupplier nanos;
  private final long startNanos;
  private Optional<Wake> wake = Optional.empty();
  private long count;

  /**
   * @param thread that is woken when something is due
   * @param due told on that thread what is due
   * @param nanos any time that goes on, in nanoseconds
   */
  Alarms(ScheduledExecutorService thread, Consumer<Runnable> due, LongSupplier nanos) {
    this.thread = thread;
    this.due = due;
    this.nanos = nanos;
    this.startNanos = nanos.getAsLong();
  }

  /** Runs nothing when it is cancelled before its time; afterwards that does nothing. */
  synchronized Clock.Timer add(long delayNanos, Runnable action) {
    long atNanos = now() + Math.min(LONGEST_NANOS, delayNanos);
    Alarm alarm = new Alarm(atNanos, count++, action);
    open.add(alarm);
    wakeAt(atNanos);
    return () -> cancel(alarm);
  }

  private synchronized void cancel(Alarm alarm) {
    open.remove(alarm);
  }

  private void wakeAt(long atNanos) {
    if (wake.filter(set -> set.atNanos <= atNanos).isEmpty()) {
      wake.ifPresent(set -> set.future.cancel(false));
      Future<?> future = thread.schedule(this::ring, atNanos - now(), TimeUnit.NANOSECONDS);
      wake = Optional.of(new Wake(atNanos, future));
    }
  }

  private void ring() {
    takeDue().forEach(due);
  }

  private synchronized List<Runnable> takeDue() {
    List<Runnable> actions = new ArrayList<>();
    wake = Optional.empty();
    while (!open.isEmpty() && open.first().atNanos <= now()) {
      actions.add(open.pollFirst().action);
    }
    if (!open.isEmpty()) {
      wakeAt(open.first().atNanos);
    }
    return actions;
  }

  private long now() {
    return nanos.getAsLong() - startNanos;
  }

  private record Alarm(long atNanos, long number, Runnable action) {}

  private record Wake(long atNanos, Future<?> future) {}
}
