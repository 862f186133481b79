package org.maestro.knowledge.habits;

import java.time.DayOfWeek;
import java.time.Duration;
import java.time.LocalTime;
import java.time.ZonedDateTime;

/** Which times are like another: about the same time of day, both at the weekend or neither. */
public final class LikeNow {
  private static final Duration DAY = Duration.ofDays(1);

  private LikeNow() {}

  /**
   * @param about how far apart the times of day may be
   */
  public static boolean are(ZonedDateTime then, ZonedDateTime now, Duration about) {
    return isWeekend(then) == isWeekend(now)
        && apart(then.toLocalTime(), now.toLocalTime()).compareTo(about) <= 0;
  }

  private static boolean isWeekend(ZonedDateTime day) {
    return day.getDayOfWeek() == DayOfWeek.SATURDAY || day.getDayOfWeek() == DayOfWeek.SUNDAY;
  }

  /** Midnight lies between two times of the day as any other moment does. */
  private static Duration apart(LocalTime one, LocalTime another) {
    Duration between = Duration.between(one, another).abs();
    Duration around = DAY.minus(between);
    return between.compareTo(around) < 0 ? between : around;
  }
}
