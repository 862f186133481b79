package org.maestro.diary;

import java.time.Instant;

/**
 * A line of the diary.
 *
 * <p>Times are those of the home's clock.
 */
public sealed interface DiaryLine {
  Instant at();

  /** The platform has begun: what was so before may have ended unseen. */
  record Begun(Instant at) implements DiaryLine {}

  /**
   * Something has become known, or is not known any more.
   *
   * @param fact in MAESTRO-SL; {@code (unknown ...)} for what is not known any more
   */
  record Became(Instant at, String fact) implements DiaryLine {}

  /**
   * Somebody has asked for something.
   *
   * @param goal in MAESTRO-SL
   * @param requester as it is written down with the goal
   */
  record Asked(Instant at, String id, String goal, String requester) implements DiaryLine {}

  /**
   * What was asked for has come to its end.
   *
   * @param end {@code reached}, {@code unseen} (reached, but nobody has seen it), {@code failed} or
   *     {@code cancelled}
   * @param reason why; "" where it was reached
   */
  record Over(Instant at, String id, String end, String reason) implements DiaryLine {}
}
