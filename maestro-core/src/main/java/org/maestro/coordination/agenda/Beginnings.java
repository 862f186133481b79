package org.maestro.coordination.agenda;

import java.util.function.Consumer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;

/** The goals that are begun when their time has come: ordinary ones, with ids of their own. */
public interface Beginnings {

  /** The id that the next goal may have; no other goal gets it. */
  String nextId();

  /** Whether a goal of that id was ever written down; if not, no other goal gets it from now on. */
  boolean wasBegun(String goalId);

  /**
   * Takes a goal on. One of both is told, perhaps before this returns.
   *
   * @param accepted it is written down
   * @param refused told in a sentence why it cannot be
   */
  void begin(String goalId, GoalRequest request, Runnable accepted, Consumer<String> refused);

  /**
   * Tells how the goal ends, or has ended.
   *
   * @return whether there is, or was, such a goal that was taken on
   */
  boolean follow(String goalId, Consumer<GoalOutcome> ended);

  /** What is to be kept by the goal is so now. */
  boolean isHolding(String goalId);

  void cancel(String goalId, String who);
}
