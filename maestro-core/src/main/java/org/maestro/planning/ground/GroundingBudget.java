package org.maestro.planning.ground;

import java.util.concurrent.CancellationException;
import java.util.function.BooleanSupplier;

/**
 * The time limit of planning: it may go on until a moment, or until somebody cancels it. It is
 * asked often, from the planning thread; who cancels may be any thread.
 */
public final class GroundingBudget {
  private static final int ASKED_BETWEEN = 64;

  private final long end;
  private final BooleanSupplier cancelled;
  private int asked;

  private GroundingBudget(long end, BooleanSupplier cancelled) {
    this.end = end;
    this.cancelled = cancelled;
  }

  /** Without an end. */
  public static GroundingBudget endless() {
    return new GroundingBudget(Long.MAX_VALUE, () -> false);
  }

  /**
   * Until some seconds from now have passed.
   *
   * @param seconds infinite for no end
   */
  public static GroundingBudget seconds(double seconds, BooleanSupplier cancelled) {
    double nanos = seconds * 1e9;
    return new GroundingBudget(
        nanos > Long.MAX_VALUE / 4.0 ? Long.MAX_VALUE : System.nanoTime() + (long) nanos,
        cancelled);
  }

  /** Until a part of the time that is left has passed. */
  public GroundingBudget part(double share) {
    return end == Long.MAX_VALUE
        ? this
        : new GroundingBudget(
            System.nanoTime() + (long) (share * (end - System.nanoTime())), cancelled);
  }

  /** Until then, and for so many seconds from now at most. */
  public GroundingBudget atMost(double seconds) {
    long then = System.nanoTime() + (long) (seconds * 1e9);
    return new GroundingBudget(end == Long.MAX_VALUE ? then : Math.min(end, then), cancelled);
  }

  public boolean isOver() {
    return cancelled.getAsBoolean() || end != Long.MAX_VALUE && System.nanoTime() - end >= 0;
  }

  /**
   * Looks at the clock.
   *
   * @throws CancellationException when it is over
   */
  public void refuseIfOver() {
    if (isOver()) {
      throw new CancellationException("Planning was stopped.");
    }
  }

  /**
   * Looks whether it was cancelled, and at the clock now and then; cheap enough for inner loops.
   *
   * @throws CancellationException when it is over
   */
  public void check() {
    // Code that was never run before is slow: sixty rounds of it may take longer than a cancel may.
    if (cancelled.getAsBoolean() || ++asked % ASKED_BETWEEN == 0) {
      refuseIfOver();
    }
  }
}
