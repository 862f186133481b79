package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Comparator;
import java.util.Optional;

/**
 * Who goes first where not all can: the higher priority, then the earlier deadline, then who asked
 * first. The first of all is the least.
 *
 * @param number counts up with each goal
 */
public record Standing(int priority, Optional<Duration> deadline, int number)
    implements Comparable<Standing> {
  private static final Duration NEVER = Duration.ofSeconds(Long.MAX_VALUE);
  private static final Comparator<Standing> ORDER =
      Comparator.comparingInt((Standing s) -> -s.priority())
          .thenComparing(s -> s.deadline().orElse(NEVER))
          .thenComparingInt(Standing::number);

  @Override
  public int compareTo(Standing other) {
    return ORDER.compare(this, other);
  }

  public Standing raisedTo(int higher) {
    return higher > priority ? new Standing(higher, deadline, number) : this;
  }
}
