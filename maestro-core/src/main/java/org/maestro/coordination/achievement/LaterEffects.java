package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.api.ActionDispatcher.Report;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.story.GoalStory;
import org.maestro.ontology.vocabulary.Timing;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.rats.time.Clock;
import org.maestro.sl.Evaluation;
import org.maestro.sl.Formula;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Substitution;
import org.maestro.sl.Truth;

/**
 * Reports of steps that have been answered and whose effect is still to come, as their features
 * say: each is held back until the effect is there, or the time is over in which it had to come.
 * The coordinator's thread only.
 */
final class LaterEffects {

  private final Ports ports;
  private final GoalStory story;
  private final Map<StepKey, Held> held = new HashMap<>();

  private record Held(Step step, Report report, Consumer<Report> then, Clock.Timer timer) {}

  LaterEffects(Ports ports, GoalStory story) {
    this.ports = ports;
    this.story = story;
  }

  /**
   * Hands the report on: at once, or when the effect is there.
   *
   * @param limit for what the member has to tell
   */
  void await(Step step, Report report, Duration limit, Consumer<Report> then) {
    Timing timing = step.feature().timing();
    Optional<Duration> wait =
        timing.doneWhen().isPresent() ? Optional.of(limit) : timing.effectAfter();
    if (!report.succeeded() || wait.isEmpty() || isThere(step)) {
      then.accept(report);
      return;
    }
    story.awaitsEffect(step, timing.doneWhen(), wait.get());
    Clock.Timer timer =
        ports
            .clock()
            .schedule(
                wait.get(),
                step.member(),
                () -> ports.owner().execute(() -> over(step.key(), wait.get())));
    held.put(step.key(), new Held(step, report, then, timer));
  }

  /** What is known has changed. */
  void look() {
    List<Held> there = new ArrayList<>(held.values());
    there.removeIf(one -> !isThere(one.step()));
    there.forEach(one -> release(one.step().key(), one.report()));
  }

  /** The member is lost, or lives anew: nobody knows what becomes of the effects to come. */
  void memberLost(String member) {
    List<StepKey> lost =
        held.keySet().stream().filter(step -> step.member().equals(member)).toList();
    lost.forEach(step -> release(step, failure(member + " was lost before the effect was there.")));
  }

  /** The step is not wanted any more; nobody knows what becomes of its effect. */
  void giveUp(StepKey step) {
    release(step, failure("It was called off before its effect was there."));
  }

  private void over(StepKey step, Duration waited) {
    Optional.ofNullable(held.get(step)).ifPresent(one -> release(step, atTheEnd(one, waited)));
  }

  private Report atTheEnd(Held one, Duration waited) {
    return one.step()
        .feature()
        .timing()
        .doneWhen()
        .filter(condition -> !isThere(one.step()))
        .map(
            condition ->
                failure(
                    "%s has answered, but it was not told within %s s that %s."
                        .formatted(
                            one.step().member(),
                            Sentences.number(waited.toMillis() / 1000.0),
                            SlPrinter.print(
                                new Substitution(one.step().values()).apply(condition)))))
        .orElse(one.report());
  }

  private void release(StepKey step, Report report) {
    Optional.ofNullable(held.remove(step))
        .ifPresent(
            one -> {
              one.timer().cancel();
              one.then().accept(report);
            });
  }

  private static Report failure(String problem) {
    return new Report(false, Map.of(), Optional.of(problem), List.of());
  }

  private boolean isThere(Step step) {
    Optional<Formula> condition = step.feature().timing().doneWhen();
    return condition.isPresent()
        && new Evaluation(ports.knowledge().snapshot()).truth(condition.get(), step.values())
            == Truth.TRUE;
  }
}
