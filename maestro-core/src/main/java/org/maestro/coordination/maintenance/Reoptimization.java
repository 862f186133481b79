package org.maestro.coordination.maintenance;

import java.time.Duration;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.rats.time.Clock;

/**
 * Has a goal that holds be held by cheaper settings when these would do. They are looked for a
 * while after the last change of settings, once at a time. The coordinator's thread only.
 */
final class Reoptimization {
  private static final Duration BETWEEN_SETTINGS = Duration.ofSeconds(60);

  private final HeldCondition condition;
  private final Ports working;
  private final CheaperSettings economy;
  private final HeldWork work;
  private final HeldStory story;
  private final ActiveGoals activeGoals;
  private final Clock clock;
  private final BooleanSupplier mayBegin;
  private final Runnable then;
  private Duration lastSetting = Duration.ZERO;
  private boolean considering;

  /**
   * @param mayBegin whether the goal holds undisturbed
   * @param then when settings were made anew
   */
  Reoptimization(
      HeldCondition condition,
      Ports working,
      CheaperSettings economy,
      HeldWork work,
      HeldStory story,
      ActiveGoals activeGoals,
      BooleanSupplier mayBegin,
      Runnable then) {
    this.condition = condition;
    this.working = working;
    this.economy = economy;
    this.work = work;
    this.story = story;
    this.activeGoals = activeGoals;
    this.clock = working.clock();
    this.mayBegin = mayBegin;
    this.then = then;
  }

  /** Settings were made just now. */
  void settled() {
    lastSetting = clock.now();
  }

  void considerIfDue() {
    if (considering || lastSetting.plus(BETWEEN_SETTINGS).compareTo(clock.now()) > 0) {
      return;
    }
    considering = true;
    settled();
    economy.consider(cheaper -> activeGoals.run(() -> considered(cheaper)));
  }

  private void considered(Optional<CheaperSettings.Cheaper> cheaper) {
    considering = false;
    if (mayBegin.getAsBoolean()) {
      cheaper.ifPresent(this::setAnew);
    }
  }

  private void setAnew(CheaperSettings.Cheaper cheaper) {
    story.cheaper(cheaper);
    work.setAnew(
        cheaper.goal(),
        working.with(new HoldingOrder(working.planner(), condition.closed())),
        () -> {
          settled();
          then.run();
        });
  }
}
