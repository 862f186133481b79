package org.maestro.rats.time;

import java.time.DateTimeException;
import java.time.Instant;
import java.time.format.DateTimeFormatter;
import java.time.format.DateTimeFormatterBuilder;
import java.util.Comparator;
import java.util.Optional;

/**
 * A time of a {@link HybridClock}: of two of which one can have caused the other, the cause's is
 * the smaller one.
 *
 * @param millis since 1970, as far as the fastest of the clocks that were heard of is
 * @param count of what happened in that millisecond before
 */
public record HybridStamp(long millis, int count) implements Comparable<HybridStamp> {
  private static final Comparator<HybridStamp> ORDER =
      Comparator.comparingLong(HybridStamp::millis).thenComparingInt(HybridStamp::count);

  /** Always with three digits behind the point, so that lines stand below each other. */
  private static final DateTimeFormatter INSTANT =
      new DateTimeFormatterBuilder().appendInstant(3).toFormatter();

  private static final char COUNTED = '/';

  @Override
  public int compareTo(HybridStamp other) {
    return ORDER.compare(this, other);
  }

  /** What {@link #toString} wrote; empty when it is no stamp. */
  public static Optional<HybridStamp> read(String text) {
    int at = text.lastIndexOf(COUNTED);
    if (at < 0) {
      return Optional.empty();
    }
    try {
      long millis = Instant.parse(text.substring(0, at)).toEpochMilli();
      int count = Integer.parseInt(text.substring(at + 1));
      return count < 0 ? Optional.empty() : Optional.of(new HybridStamp(millis, count));
    } catch (DateTimeException | NumberFormatException | ArithmeticException e) {
      return Optional.empty();
    }
  }

  /** Such as {@code 2026-01-31T12:00:00.000Z/3}. */
  @Override
  public String toString() {
    return INSTANT.format(Instant.ofEpochMilli(millis)) + COUNTED + count;
  }
}
