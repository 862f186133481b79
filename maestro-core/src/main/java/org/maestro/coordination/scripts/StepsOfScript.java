package org.maestro.coordination.scripts;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import org.maestro.coordination.api.ScriptStep;
import org.maestro.coordination.api.StepRecord.State;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Body;

/**
 * The steps of one script in the order in which they are written, and where each stands: done,
 * under way, to come. Of a loop the latest round is kept. The coordinator's thread only.
 */
final class StepsOfScript {
  private final Clock clock;
  private final List<ScriptStep> steps = new ArrayList<>();

  StepsOfScript(Clock clock) {
    this.clock = clock;
  }

  List<ScriptStep> all() {
    return List.copyOf(steps);
  }

  /** The script as a whole. */
  void laidOut(Body.Seq script) {
    steps.addAll(Layout.inTurn(script.parts(), "", 0));
  }

  /**
   * What is done within the step is this from now on: a round of a loop, or a script that is run.
   */
  void within(String path, int number, Body body) {
    for (int i = 0; i < steps.size(); i++) {
      if (steps.get(i).path().equals(path)) {
        int depth = steps.get(i).depth() + 1;
        steps.removeIf(below(path));
        steps.addAll(i + 1, Layout.of(body, Place.below(path, number), depth));
        return;
      }
    }
  }

  void begun(String path) {
    change(at(path), step -> step.begunAt(clock.now()));
  }

  void ended(String path, Result result) {
    change(
        at(path).and(step -> step.state() == State.UNDER_WAY),
        step -> step.endedAt(clock.now(), state(result), result.problem()));
    dropWhatWaits(path);
  }

  /** It was over before a restart; what became of the steps in it is not told any more. */
  void wasOver(String path, Result result) {
    change(at(path), step -> step.overBefore(state(result), result.problem()));
    steps.removeIf(below(path));
  }

  void calledOff(String path) {
    change(
        at(path).and(step -> step.state() == State.UNDER_WAY),
        step -> step.endedAt(clock.now(), State.CALLED_OFF, Optional.empty()));
    dropWhatWaits(path);
  }

  private static State state(Result result) {
    return result instanceof Result.Failed ? State.FAILED : State.DONE;
  }

  private void dropWhatWaits(String path) {
    change(
        at(path).or(below(path)).and(step -> step.state() == State.WAITING), ScriptStep::dropped);
  }

  private static Predicate<ScriptStep> at(String path) {
    return step -> step.path().equals(path);
  }

  private static Predicate<ScriptStep> below(String path) {
    String begin = path.isEmpty() ? "" : path + ".";
    return step -> step.path().startsWith(begin);
  }

  private void change(Predicate<ScriptStep> meant, UnaryOperator<ScriptStep> now) {
    steps.replaceAll(step -> meant.test(step) ? now.apply(step) : step);
  }
}
