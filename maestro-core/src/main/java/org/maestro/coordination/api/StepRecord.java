package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Optional;
import org.maestro.planning.api.Step;

/**
 * A step of a plan that was made, and what has become of it.
 *
 * @param sentence what is done, for people
 * @param start as it was planned, from the beginning of the plan's first step
 * @param begun simulated time since the platform's start
 * @param ended the same
 * @param problem one sentence of a step that failed
 */
public record StepRecord(
    Step step,
    String sentence,
    Duration start,
    State state,
    Optional<Duration> begun,
    Optional<Duration> ended,
    Optional<String> problem) {

  /** Where a step stands. */
  public enum State {
    WAITING,
    UNDER_WAY,
    DONE,
    FAILED,
    /** It had begun, and was no longer wanted. */
    CALLED_OFF,
    /** It never began: another plan took the place of its own, or the goal ended. */
    DROPPED
  }

  /** One that has not begun. */
  public StepRecord(Step step, String sentence, Duration start) {
    this(
        step, sentence, start, State.WAITING, Optional.empty(), Optional.empty(), Optional.empty());
  }

  public StepRecord begunAt(Duration time) {
    return new StepRecord(
        step,
        sentence,
        start,
        State.UNDER_WAY,
        Optional.of(time),
        Optional.empty(),
        Optional.empty());
  }

  public StepRecord endedAt(Duration time, State how, Optional<String> why) {
    return new StepRecord(step, sentence, start, how, begun, Optional.of(time), why);
  }

  /** It was not begun after all. */
  public StepRecord waitingAgain() {
    return new StepRecord(step, sentence, start);
  }

  /** Nothing will come of it. */
  public StepRecord dropped() {
    return new StepRecord(step, sentence, start, State.DROPPED, begun, ended, problem);
  }
}
