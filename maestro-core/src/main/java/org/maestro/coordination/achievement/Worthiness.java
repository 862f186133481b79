package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.Optional;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Worth;
import org.maestro.coordination.story.GoalPhase;

/**
 * The worth of one goal, seen from its plan: told with each plan, and waited for as long as the
 * plan costs more than the goal brings (ADE, 4.1; A52). The coordinator's thread only.
 */
final class Worthiness {
  private static final Duration BETWEEN_PRICES = Duration.ofSeconds(30);

  private final PursuitParts parts;
  private final GoalTransitions course;
  private boolean isToBePriced;

  Worthiness(PursuitParts parts, GoalTransitions course) {
    this.parts = parts;
    this.course = course;
  }

  private Optional<Worth> now() {
    return parts.activeGoals().appraisals().find(parts.id());
  }

  /** A plan was taken. */
  void planned() {
    parts.activeGoals().appraisals().planned(parts.id(), parts.life().plans() == 1);
    if (!parts.monitor().isConfirming()) {
      now().ifPresent(parts.story()::worth);
    }
  }

  /** Less is left to be paid. */
  void advanced() {
    parts.activeGoals().appraisals().advanced(parts.id());
  }

  /**
   * Whether nothing is to be begun now. What costs more than it brings is not begun, and not gone
   * on with from a safe point on: what was spent on it before is no reason. Whether it has been
   * reached is seen in any case.
   */
  boolean isWanting() {
    Optional<Worth> worth = now().filter(present -> !present.isWorthIt());
    if (worth.isEmpty()
        || parts.monitor().isConfirming()
        || !parts.underway().isEmpty()
        || parts.resourceClaims().isTied()) {
      return false;
    }
    parts.preemption().rest();
    if (!isWaitedFor()) {
      parts.life().become(GoalPhase.WAITING_FOR_WORTH, worth.get().deficitInWords());
      parts.story().notWorthIt(worth.get());
    }
    return true;
  }

  private boolean isWaitedFor() {
    return parts.life().phase() == GoalPhase.WAITING_FOR_WORTH;
  }

  /**
   * Something has changed that the plan's cost depends on. Another plan may cost less now; but who
   * drives by changes much, and again the next moment.
   */
  void mayCostLess() {
    if (isWaitedFor() && !isToBePriced) {
      isToBePriced = true;
      Ports ports = parts.ports();
      ports
          .clock()
          .schedule(
              BETWEEN_PRICES,
              parts.id(),
              () -> ports.owner().execute(() -> parts.activeGoals().run(this::priceAgain)));
    }
  }

  private void priceAgain() {
    isToBePriced = false;
    if (isWaitedFor()) {
      course.makePlan(Optional.of("things have changed that its cost depends on"));
    }
  }
}
