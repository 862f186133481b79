package org.maestro.knowledge.belief;

import java.time.Duration;
import java.time.Instant;
import org.maestro.rats.time.Clock;

/**
 * Wakes when the next belief is too old to count, so that whoever counts on it need not find out by
 * chance. Thread-safe.
 */
public final class Ageing implements AutoCloseable {

  /** A belief counts at its last instant; it is looked for just after. */
  private static final Duration AFTER = Duration.ofMillis(1);

  private static final Clock.Timer NONE = () -> {};

  private final Clock clock;
  private final Runnable age;
  private Instant due = Instant.MAX;
  private Clock.Timer timer = NONE;
  private boolean closed;

  /**
   * @param age on the clock's thread; has to say again what it expects next
   */
  public Ageing(Clock clock, Runnable age) {
    this.clock = clock;
    this.age = age;
  }

  /** Something expires then; {@link Instant#MAX} says that nothing does. */
  public synchronized void expect(Instant expiry) {
    if (!closed && expiry.isBefore(due)) {
      timer.cancel();
      due = expiry;
      Duration delay = Duration.between(clock.instant(), expiry).plus(AFTER);
      timer = clock.schedule(delay, "knowledge", this::wake);
    }
  }

  private void wake() {
    synchronized (this) {
      if (closed) {
        return;
      }
      due = Instant.MAX;
      timer = NONE;
    }
    age.run();
  }

  @Override
  public synchronized void close() {
    closed = true;
    timer.cancel();
  }
}
