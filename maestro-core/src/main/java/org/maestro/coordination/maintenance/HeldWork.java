package org.maestro.coordination.maintenance;

import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.sl.Formula;

/**
 * The work that is done for a held goal now, if any is: a pursuit of its own that ends, so that the
 * goal keeps nothing from others while it holds. Either the goal is brought about, or its settings
 * are made anew while it holds. The coordinator's thread only.
 */
final class HeldWork {
  private final Wish wish;
  private final ActiveGoals activeGoals;
  private final Reaching reaching;
  private final ActiveGoal held;
  private final Runnable over;
  private Optional<Work> current = Optional.empty();
  private Decisions decisions = new Decisions();
  private PlanRecords plans;

  private enum Purpose {
    BRINGING_ABOUT,
    SETTING_ANEW
  }

  private record Work(ActiveGoal pursuit, Purpose purpose) {}

  /**
   * @param held whose work it is; it stands for the goal again when the work is over
   * @param plans what stands for its plans before there is any
   * @param over told each time that work is over, whatever comes after it
   */
  HeldWork(
      Wish wish,
      ActiveGoals activeGoals,
      Reaching reaching,
      ActiveGoal held,
      PlanRecords plans,
      Runnable over) {
    this.wish = wish;
    this.activeGoals = activeGoals;
    this.reaching = reaching;
    this.held = held;
    this.over = over;
    this.plans = plans;
  }

  Optional<ActiveGoal> current() {
    return current.map(Work::pursuit);
  }

  boolean isNone() {
    return current.isEmpty();
  }

  /** The work of bringing the goal about, so that it cannot hold already. */
  Optional<ActiveGoal> bringingAbout() {
    return current.filter(work -> work.purpose() == Purpose.BRINGING_ABOUT).map(Work::pursuit);
  }

  boolean isBringingAbout() {
    return bringingAbout().isPresent();
  }

  <T> Optional<T> asked(Function<ActiveGoal, Optional<T>> question) {
    return current().flatMap(question);
  }

  /** Of what is done now, or was done last. */
  Decisions decisions() {
    return decisions;
  }

  /** Of the same. */
  PlanRecords plans() {
    return plans;
  }

  double seconds(ToDoubleFunction<ActiveGoal> question) {
    return current().map(question::applyAsDouble).orElse(0.0);
  }

  void told(Consumer<ActiveGoal> news) {
    current().ifPresent(news);
  }

  /** It is not started yet. */
  ActiveGoal bringAbout(Formula goal, Ports with, Consumer<GoalOutcome> then) {
    return begin(Purpose.BRINGING_ABOUT, goal, with, then);
  }

  void setAnew(Formula goal, Ports with, Runnable then) {
    begin(Purpose.SETTING_ANEW, goal, with, outcome -> then.run()).start();
  }

  private ActiveGoal begin(Purpose purpose, Formula goal, Ports with, Consumer<GoalOutcome> then) {
    GoalRequest once =
        new GoalRequest(
            goal, wish.request().requester(), wish.request().priority(), Optional.empty());
    ActiveGoal[] begun = new ActiveGoal[1];
    begun[0] =
        reaching.pursuit(
            once, with, outcome -> activeGoals.run(() -> ended(begun[0], outcome, then)));
    current = Optional.of(new Work(begun[0], purpose));
    decisions = begun[0].decisions();
    plans = begun[0].plans();
    return begun[0];
  }

  private void ended(ActiveGoal ended, GoalOutcome outcome, Consumer<GoalOutcome> then) {
    if (current().filter(now -> now == ended).isPresent()) {
      current = Optional.empty();
      over.run();
      activeGoals.enter(held, wish.standing());
      then.accept(outcome);
    }
  }

  void stop() {
    Optional<ActiveGoal> stopped = current();
    current = Optional.empty();
    if (stopped.isPresent()) {
      stopped.get().cancel(wish.id());
      over.run();
      activeGoals.enter(held, wish.standing());
    }
  }
}
