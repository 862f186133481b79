package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Comparator;
import java.util.Optional;

/**
 * The precedence of a goal where not all can go first: the higher priority, then the earlier
 * deadline, then who asked first. The first of all is the least.
 *
 * @param number counts up with each goal
 */
public record GoalPriority(int priority, Optional<Duration> deadline, int number)
    implements Comparable<GoalPriority> {
  private static final Duration NEVER = Duration.ofSeconds(Long.MAX_VALUE);
  private static final Comparator<GoalPriority> ORDER =
      Comparator.comparingInt((GoalPriority s) -> -s.priority())
          .thenComparing(s -> s.deadline().orElse(NEVER))
          .thenComparingInt(GoalPriority::number);

  @Override
  public int compareTo(GoalPriority other) {
    return ORDER.compare(this, other);
  }

  public GoalPriority raisedTo(int higher) {
    return higher > priority ? new GoalPriority(higher, deadline, number) : this;
  }
}
