package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Comparator;
import java.util.Optional;

/**
 * The precedence of a goal where not all can go first: the higher stated priority, which nothing
 * computed outbids; then the higher grade of worth; then the earlier deadline; then who asked
 * first. The first of all is the least.
 *
 * @param grade of what it is worth ({@link Worth#priority}), in steps of five percent, so that two
 *     goals do not take things from each other all the time
 * @param number counts up with each goal
 */
public record GoalPriority(int priority, int grade, Optional<Duration> deadline, int number)
    implements Comparable<GoalPriority> {
  private static final double STEP = 1.05;

  /** A goal of which nobody says what it is worth counts as one worth exactly this much. */
  public static final double UNWEIGHED_WORTH = 100;

  /** The grade of the same. */
  public static final int UNWEIGHED = grade(UNWEIGHED_WORTH);

  /** The grade of what costs more than it brings. */
  public static final int WORTHLESS = Integer.MIN_VALUE;

  private static final Duration NEVER = Duration.ofSeconds(Long.MAX_VALUE);
  private static final Comparator<GoalPriority> BY_RANK =
      Comparator.comparingInt(GoalPriority::priority).thenComparingInt(GoalPriority::grade);
  private static final Comparator<GoalPriority> ORDER =
      BY_RANK
          .reversed()
          .thenComparing(s -> s.deadline().orElse(NEVER))
          .thenComparingInt(GoalPriority::number);

  /** The precedence of a goal of which nobody says what it is worth. */
  public GoalPriority(int priority, Optional<Duration> deadline, int number) {
    this(priority, UNWEIGHED, deadline, number);
  }

  /**
   * The grade of a worth.
   *
   * @param worth above 0
   */
  static int grade(double worth) {
    return (int) Math.floor(Math.log(worth) / Math.log(STEP));
  }

  /** The least worth that is of the grade. */
  static double lowestOf(int grade) {
    return Math.pow(STEP, grade);
  }

  public GoalPriority graded(int other) {
    return new GoalPriority(priority, other, deadline, number);
  }

  @Override
  public int compareTo(GoalPriority other) {
    return ORDER.compare(this, other);
  }

  /** Whether the other has to give way to it: an earlier deadline or an older goal is no reason. */
  public boolean outranks(GoalPriority other) {
    return BY_RANK.compare(this, other) > 0;
  }

  /** The same goal, going as early as the other where that goes first. */
  public GoalPriority raisedTo(GoalPriority other) {
    return other.outranks(this)
        ? new GoalPriority(other.priority, other.grade, deadline, number)
        : this;
  }
}
