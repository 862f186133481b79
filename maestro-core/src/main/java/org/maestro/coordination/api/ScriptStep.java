package org.maestro.coordination.api;

import java.time.Duration;
import java.util.Optional;
import org.maestro.coordination.api.StepRecord.State;

/**
 * A step of a script as it is written, and what has become of it.
 *
 * @param path of its place in the script, as the story has it, such as 2.1
 * @param depth how many other steps it is in
 * @param text what is written, without the steps in it
 * @param begun simulated time since the platform's start; empty also for what was over before a
 *     restart
 * @param ended the same
 * @param problem why it failed
 */
public record ScriptStep(
    String path,
    int depth,
    String text,
    State state,
    Optional<Duration> begun,
    Optional<Duration> ended,
    Optional<String> problem) {

  /** One that has not begun. */
  public ScriptStep(String path, int depth, String text) {
    this(path, depth, text, State.WAITING, Optional.empty(), Optional.empty(), Optional.empty());
  }

  /** Also once more, after it was not to begin any more. */
  public ScriptStep begunAt(Duration time) {
    return new ScriptStep(
        path, depth, text, State.UNDER_WAY, Optional.of(time), Optional.empty(), Optional.empty());
  }

  public ScriptStep endedAt(Duration time, State how, Optional<String> why) {
    return new ScriptStep(path, depth, text, how, begun, Optional.of(time), why);
  }

  /** It was over before a restart, and nobody knows when. */
  public ScriptStep overBefore(State how, Optional<String> why) {
    return new ScriptStep(path, depth, text, how, Optional.empty(), Optional.empty(), why);
  }

  /** Nothing will come of it. */
  public ScriptStep dropped() {
    return new ScriptStep(path, depth, text, State.DROPPED, begun, ended, problem);
  }
}
