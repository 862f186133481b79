package org.maestro.coordination.achievement;

import java.util.List;
import java.util.Optional;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.facts.KnowledgeVersion;
import org.maestro.coordination.story.Decision;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;

/**
 * Has plans made for one goal, one after the other, and takes none that things have outrun. The
 * coordinator's thread only.
 */
final class GoalPlanning {
  /** Since another place was found not to be the one: a search comes to its end by itself. */
  private static final int MOST_PLANS = 60;

  /** Looks that do not show it, again and again, show nothing either. */
  private static final int MOST_CONFIRMATIONS = 10;

  private final PursuitParts parts;
  private final GoalTransitions course;
  private Optional<String> planAgain = Optional.empty();
  private final Decisions decisions = new Decisions();
  private FactFilter changedMeanwhile;
  private KnowledgeVersion begunWith;
  private int placesLookedAt;
  private int plansBefore;

  GoalPlanning(PursuitParts parts, GoalTransitions course) {
    this.parts = parts;
    this.course = course;
    this.changedMeanwhile = nothing();
    this.begunWith = parts.monitor().look();
  }

  private FactFilter nothing() {
    return new FactFilter(parts.ports().knowledge().home().vocabulary());
  }

  Decisions decisions() {
    return decisions;
  }

  void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    if (isPlanning() && !begunWith.has(change, changed)) {
      changedMeanwhile.addAll(changed);
    }
  }

  /** No plan without it counts for what is possible with it. */
  void memberPresent(String member) {
    if (isPlanning() && planAgain.isEmpty() && parts.monitor().isCandidate(member)) {
      planAgain = Optional.of(member + " is there");
    }
  }

  void makePlanAgain(String why) {
    planAgain = Optional.of(why);
  }

  void makePlan(Optional<String> why) {
    if (isPlanning()) {
      planAgain = why;
      return;
    }
    GoalLife life = parts.life();
    boolean confirming = parts.monitor().isConfirming();
    if (confirming && life.confirmingPlans() >= MOST_CONFIRMATIONS) {
      parts.plan().drop();
      lookedInVain();
      return;
    }
    if (parts.monitor().lessons().placesLookedAt() > placesLookedAt) {
      placesLookedAt = parts.monitor().lessons().placesLookedAt();
      plansBefore = life.plans();
    }
    if (life.phase() == GoalPhase.WAITING_FOR_WORTH || life.phase() == GoalPhase.WAITING_FOR_RANK) {
      plansBefore = life.plans();
    }
    if (life.plans() - plansBefore >= MOST_PLANS) {
      course.giveUp(
          List.of("It was planned " + life.plans() + " times without getting there; given up."));
      return;
    }
    parts.monitor().planBegins();
    changedMeanwhile = nothing();
    begunWith = parts.monitor().look();
    parts.preemption().forget();
    life.countPlan(confirming);
    life.become(phaseWhilePlanning(why), why.orElse(""));
    parts.story().planning(life.plans(), why);
    new PlanMaking(
            parts.id(),
            life.plans() > 1 || confirming ? parts.ports().patient() : parts.ports(),
            parts.roster(),
            parts.exactPrices(),
            parts.monitor(),
            parts.activeGoals(),
            parts.resourceClaims(),
            parts.story(),
            round -> parts.activeGoals().run(() -> planned(round)))
        .start();
  }

  /** Who says again and again that it is done, and it is never seen, is not believed. */
  private void lookedInVain() {
    if (parts.monitor().holds().isPresent()) {
      course.giveUp(
          List.of(
              "It is said to be so, and was to be seen %d times, and never was."
                  .formatted(parts.life().confirmingPlans()),
              GoalEnding.NOT_PROVEN));
    } else {
      course.noPlanToSeeIt();
    }
  }

  private boolean isPlanning() {
    return parts.life().phase().isPlanning();
  }

  private GoalPhase phaseWhilePlanning(Optional<String> why) {
    if (parts.monitor().isConfirming()) {
      return GoalPhase.PLANNING_TO_SEE;
    }
    return why.isPresent() ? GoalPhase.REPLANNING : GoalPhase.PLANNING;
  }

  private void planned(PlanningRound.Ended round) {
    if (parts.life().isOver()) {
      round.tender().reject();
    } else {
      parts.life().become(GoalPhase.DECIDING);
      take(round);
    }
  }

  private void take(PlanningRound.Ended round) {
    parts.monitor().offered(round.features());
    if (isSeenMeanwhile()) {
      round.tender().reject();
      course.settle(parts.monitor().holds().orElseThrow().goalBinding());
      return;
    }
    parts
        .story()
        .bids(
            round.tender().bids(),
            round.tender().notCalled(),
            round.questions(),
            round.unpriced(),
            round.answers());
    Optional<String> why = planAgain.or(() -> changedMeanwhile(round.result()));
    planAgain = Optional.empty();
    if (why.isPresent() && !isStillGood(round.result())) {
      round.tender().reject();
      makePlan(why);
    } else if (round.result() instanceof PlanningResult.Found found
        && !(parts.monitor().isFindingOut() && found.plan().steps().isEmpty())) {
      found
          .atLeast()
          .ifPresent(
              atLeast -> parts.story().notProven(round.task().objective(), atLeast, found.plan()));
      note(found.plan(), round);
      course.adopt(found.plan(), round.tender());
    } else {
      round.tender().reject();
      course.noPlan(round);
    }
  }

  /** While it was planned how to see it, somebody told: nothing is left to be looked for. */
  private boolean isSeenMeanwhile() {
    GoalMonitor monitor = parts.monitor();
    return monitor.isConfirming()
        && parts.underway().isEmpty()
        && monitor.holds().filter(p -> monitor.toBeSeen(p.goalBinding()).isEmpty()).isPresent();
  }

  private Optional<String> changedMeanwhile(PlanningResult result) {
    return result instanceof PlanningResult.Found found
            && parts.monitor().concern(found.plan().steps()).perhaps(changedMeanwhile)
        ? Optional.of("things have changed while it was planned")
        : Optional.empty();
  }

  /** Something happened while it was planned: is the plan the right one all the same? */
  private boolean isStillGood(PlanningResult result) {
    return result instanceof PlanningResult.Found found
        && found.plan().steps().stream().allMatch(step -> parts.roster().isPresent(step.member()))
        && parts.monitor().isGood(found.plan().steps());
  }

  private void note(Plan found, PlanningRound.Ended round) {
    if (!parts.monitor().isConfirming() && !found.steps().isEmpty()) {
      decisions.add(
          parts.life().plans(),
          new Decision(round.task(), found, round.tender().bids(), round.questions()));
    }
  }
}
