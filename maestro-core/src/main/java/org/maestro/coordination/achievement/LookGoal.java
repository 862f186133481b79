package org.maestro.coordination.achievement;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.PlanPurpose;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.story.Decisions;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.planning.api.Plan;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * A look whether something is somewhere, with all that has to be done for it, beside the plan of
 * the goal that seeks it. It is over as soon as that is known, and does not insist: what it cannot
 * do at once, its goal will. The coordinator's thread only.
 */
final class LookGoal extends PlannedPursuit {
  /** What has to be measured and lit for it takes a few. */
  private static final int MOST_PLANS = 8;

  private final Formula.Atom sought;
  private final double mostCost;
  private final GoalPlanning planning;

  /**
   * @param mostCost cost units; a dearer one is left to the plan, which weighs it
   * @param of those of the goal that seeks it
   */
  LookGoal(
      String id,
      Formula.Atom sought,
      double mostCost,
      GoalRequest request,
      Ports ports,
      PursuitParts of,
      Consumer<GoalOutcome> ended) {
    super(
        id,
        request,
        ports,
        of.roster(),
        of.activeGoals(),
        of.exactPrices(),
        new VainDeeds(),
        PlanPurpose.LOOK,
        ended);
    this.sought = sought;
    this.mostCost = mostCost;
    this.planning = new GoalPlanning(parts, this);
  }

  @Override
  public void start() {
    if (!life.isOver()) {
      makePlan(Optional.empty());
    }
  }

  /** Its goal begins such looks anew after a restart. */
  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    goal.calls().forEach(call -> former.giveUp(call, "the search is planned anew"));
    giveUp(List.of("The search is planned anew."));
  }

  private boolean isDecided() {
    return parts.ports().knowledge().snapshot().truth(sought) != Truth.UNKNOWN;
  }

  @Override
  public void makePlan(Optional<String> why) {
    if (life.isOver()) {
      return;
    }
    if (isDecided()) {
      settle(Map.of());
    } else if (life.plans() >= MOST_PLANS) {
      giveUp(
          List.of(
              "It was planned %d times without getting there; given up.".formatted(life.plans())));
    } else {
      planning.makePlan(why);
    }
  }

  @Override
  public void makePlanAgain(String why) {
    planning.makePlanAgain(why);
  }

  @Override
  public void adopt(Plan found, ContractNet.Round tender) {
    if (found.cost() > mostCost) {
      tender.reject();
      giveUp(
          List.of(
              "That costs %s now; it is not looked there beside the plan."
                  .formatted(Sentences.number(found.cost()))));
    } else {
      super.adopt(found, tender);
    }
  }

  @Override
  public void noPlan(PlanningRound.Ended round) {
    if (isDecided()) {
      settle(Map.of());
    } else {
      giveUp(List.of("It cannot be looked there now."));
    }
  }

  @Override
  public void noPlanToSeeIt() {
    settle(Map.of());
  }

  @Override
  public void settle(Map<String, Term> binding) {
    end(GoalState.ACHIEVED, List.of());
  }

  @Override
  public void giveUp(List<String> reasons) {
    end(GoalState.FAILED, reasons);
  }

  @Override
  public void cancel(String who) {
    end(GoalState.CANCELLED, List.of("Cancelled by " + who + "."));
  }

  @Override
  public void deadlinePassed() {
    cancel("its deadline");
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    if (!life.isOver() && isDecided()) {
      settle(Map.of());
      return;
    }
    planning.knowledgeChanged(change, changed);
    following.knowledgeChanged(change, changed);
  }

  @Override
  public Decisions decisions() {
    return planning.decisions();
  }

  @Override
  public Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other) {
    return life.isOver()
        ? Optional.empty()
        : parts.resourceClaims().spoiledBy(changes, now, false, false);
  }
}
