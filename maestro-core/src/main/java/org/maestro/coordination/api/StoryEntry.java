package org.maestro.coordination.api;

import java.time.Duration;

/**
 * One sentence of a goal's story.
 *
 * @param at simulated time since the platform's start
 */
public record StoryEntry(String goalId, Duration at, Kind kind, String text) {

  public enum Kind {
    GOAL,
    RESTART,
    KNOWN,
    BIDS,
    PLAN,
    /** What it is worth, by which it goes before others or gives way. */
    WORTH,
    WAIT,
    STEP,
    DONE,
    FAILED,
    LEARNT,
    /** Somebody was told something, or asked. */
    SAID,
    MISCONDUCT,
    REPLAN,
    CONFIRM,
    SEARCHED,
    /** A held goal is so, for the first time or again. */
    HELD,
    /** A held goal is not so any more. */
    LOST,
    END
  }
}
