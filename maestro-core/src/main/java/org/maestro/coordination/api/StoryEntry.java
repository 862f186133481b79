package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Set;

/**
 * One sentence of a goal's story.
 *
 * @param at simulated time since the platform's start
 * @param privateWords of the home that its goal uses: it is told to who may read all of them
 */
public record StoryEntry(
    String goalId, Duration at, Kind kind, String text, Set<String> privateWords) {
  public StoryEntry {
    privateWords = Set.copyOf(privateWords);
  }

  /** A sentence for everybody. */
  public StoryEntry(String goalId, Duration at, Kind kind, String text) {
    this(goalId, at, kind, text, Set.of());
  }

  /** The same of a goal that uses these words. */
  public StoryEntry using(Set<String> words) {
    return new StoryEntry(goalId, at, kind, text, words);
  }

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
