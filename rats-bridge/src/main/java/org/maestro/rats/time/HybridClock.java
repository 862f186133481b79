package org.maestro.rats.time;

import java.time.InstantSource;

/**
 * A hybrid logical clock (Kulkarni, Demirbas, Madappa, Avva and Leone, Logical Physical Clocks,
 * 2014) of one process: its stamps are those of the wall's clock, but never go back, and are later
 * than every stamp that was heard of from another process (ADE, 3.3; A43). They lie as far from the
 * wall's clock here as the clocks of all processes lie apart at most. Any thread may use it.
 */
public final class HybridClock {
  /** A process has one log and is one host to others, so there is one. */
  private static final HybridClock PROCESS = new HybridClock(InstantSource.system());

  private final InstantSource wall;

  /** Guarded by this. */
  private HybridStamp last = new HybridStamp(Long.MIN_VALUE, 0);

  /**
   * @param wall the clock of this machine, which may go wrong or be set
   */
  public HybridClock(InstantSource wall) {
    this.wall = wall;
  }

  /** That of this process, by which its log is dated. */
  public static HybridClock ofProcess() {
    return PROCESS;
  }

  /** The time of something that happens here, or is sent from here. */
  public synchronized HybridStamp now() {
    return next(last);
  }

  /**
   * The time at which something arrives here.
   *
   * @param sent when it was sent, by the sender's clock
   */
  public synchronized HybridStamp received(HybridStamp sent) {
    return next(sent.compareTo(last) > 0 ? sent : last);
  }

  private HybridStamp next(HybridStamp before) {
    long present = wall.millis();
    last =
        present > before.millis()
            ? new HybridStamp(present, 0)
            : new HybridStamp(before.millis(), before.count() + 1);
    return last;
  }
}
