package org.maestro.rats.stream;

import java.time.Duration;
import java.util.Arrays;
import java.util.Optional;

/**
 * The figures of one stream: how many frames arrived, how many did not, and how late they were. Of
 * the latest hundred thousand frames. Any thread may use it.
 */
public final class StreamFigures {
  private static final int MOST_KEPT = 100_000;

  private long[] delays = new long[64];
  private long frames;
  private long missed;
  private long gaps;
  private long bytes;

  public synchronized void add(StreamReceiver.Received received) {
    int kept = kept();
    if (kept == delays.length && kept < MOST_KEPT) {
      delays = Arrays.copyOf(delays, Math.min(MOST_KEPT, 2 * kept));
    }
    delays[(int) (frames % MOST_KEPT)] = received.delay().toNanos();
    frames++;
    bytes += received.frame().data().length;
    missed += received.missed();
    gaps += received.missed() > 0 ? 1 : 0;
  }

  private int kept() {
    return (int) Math.min(frames, MOST_KEPT);
  }

  public synchronized long frames() {
    return frames;
  }

  /** Frames that did not arrive though later ones did. */
  public synchronized long missed() {
    return missed;
  }

  /** Places where some are missing. */
  public synchronized long gaps() {
    return gaps;
  }

  /** Of the frames' data. */
  public synchronized long bytes() {
    return bytes;
  }

  /**
   * The delay that a share of the frames do not exceed, by the nearest rank; empty before the
   * first.
   *
   * @param share 0 to 1: 0 is the shortest, 1 the longest
   */
  public synchronized Optional<Duration> delay(double share) {
    int kept = kept();
    if (kept == 0) {
      return Optional.empty();
    }
    long[] sorted = Arrays.copyOf(delays, kept);
    Arrays.sort(sorted);
    int rank = (int) Math.ceil(share * kept) - 1;
    return Optional.of(Duration.ofNanos(sorted[Math.max(0, Math.min(kept - 1, rank))]));
  }
}
