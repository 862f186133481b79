package org.maestro.coordination.achievement;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanPurpose;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.Takeover;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.recovery.FormerLessons;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.planning.api.Plan;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * A goal that is reached once: planned ({@link GoalPlanning}), its plan followed ({@link
 * PlanFollowing}), seen, ended ({@link GoalEnding}). The coordinator's thread only.
 */
public final class AchievementGoal extends PlannedPursuit {
  private final GoalPlanning planning;
  private final LooksBeside looks;
  private final GoalEnding ending;

  /**
   * @param deeds what was done for the goal before, when it is tried again
   */
  public AchievementGoal(
      String id,
      GoalRequest request,
      Ports ports,
      Roster roster,
      ActiveGoals activeGoals,
      ExactPrices exactPrices,
      VainDeeds deeds,
      Consumer<GoalOutcome> ended) {
    super(id, request, ports, roster, activeGoals, exactPrices, deeds, PlanPurpose.REACH, ended);
    this.planning = new GoalPlanning(parts, this);
    this.looks = new LooksBeside(parts, this::lookIsOver);
    this.ending = new GoalEnding(parts, this::release, this);
  }

  @Override
  public void start() {
    if (!life.isOver()) {
      parts.story().submitted(life.request());
      makePlan(Optional.empty());
    }
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    if (life.isOver()) {
      goal.calls().forEach(call -> former.giveUp(call, "its goal is over"));
      return;
    }
    parts.story().takenUp(goal);
    looks.takeUp(goal);
    new FormerLessons(parts.ports().knowledge(), parts.activeGoals().experience())
        .learnAgain(goal.memory().failures());
    for (Recovery.UnfinishedCall call : goal.calls()) {
      Optional<String> obstacle = former.obstacle(call);
      parts.story().takenUp(call, obstacle);
      if (obstacle.isPresent()) {
        former.giveUp(call, obstacle.get());
      } else {
        following.takeUp(former.order(call));
      }
    }
    if (parts.underway().isEmpty()) {
      makePlan(
          goal.effort().plans() == 0
              ? Optional.empty()
              : Optional.of("the coordinator was started again"));
    } else {
      life.become(GoalPhase.RECOVERING, "what was under way before the restart has to end first");
    }
  }

  @Override
  public void cancel(String who) {
    if (!life.isOver()) {
      ending.end(GoalState.CANCELLED, List.of("Cancelled by " + who + "."));
    }
  }

  @Override
  public void deadlinePassed() {
    if (!life.isOver()) {
      ending.end(
          GoalState.FAILED, List.of("Its deadline has passed" + life.standingInWords() + "."));
    }
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    planning.knowledgeChanged(change, changed);
    following.knowledgeChanged(change, changed);
    ending.knowledgeChanged();
  }

  @Override
  public void memberPresent(String member) {
    planning.memberPresent(member);
    ending.memberPresent(member);
  }

  @Override
  public void offered(Takeover offer) {
    following.offered(offer);
  }

  @Override
  public void doubtOver(String member) {
    ending.doubtOver(member);
  }

  @Override
  public void makePlan(Optional<String> why) {
    if (life.phase() == GoalPhase.RUNNING && looks.goOnAlone()) {
      awaitLooks();
    } else if (life.phase() != GoalPhase.WAITING_FOR_LOOKS || !looks.goOnAlone()) {
      planning.makePlan(why);
    }
  }

  private void awaitLooks() {
    parts.plan().drop();
    parts.resourceClaims().letGo();
    life.become(GoalPhase.WAITING_FOR_LOOKS, "for looks beside each other");
    parts.story().awaitsLooks();
    looks.planDropped();
  }

  @Override
  public void makePlanAgain(String why) {
    planning.makePlanAgain(why);
  }

  @Override
  public void adopt(Plan found, ContractNet.Round tender) {
    following.adopt(found, tender);
    looks.adopted(found);
  }

  private void release(GoalState how) {
    looks.end();
    following.release(how);
  }

  @Override
  public void noPlan(PlanningRound.Ended round) {
    if (looks.isAny()) {
      awaitLooks();
    } else if (parts.monitor().hasLeftOutWhatMayBe()) {
      planning.makePlan(Optional.of("a look beside the plan has shown something else"));
    } else {
      ending.noPlan(round);
    }
  }

  /** Without a plan of its own it waits for those looks. */
  private void lookIsOver() {
    if (life.phase() == GoalPhase.WAITING_FOR_LOOKS && (looks.haveFound() || !looks.isAny())) {
      makePlan(Optional.of(looks.haveFound() ? "what it seeks is found" : "all looks are over"));
    }
  }

  @Override
  public void noPlanToSeeIt() {
    ending.noPlanToSeeIt();
  }

  @Override
  public void advance() {
    following.advance();
    ending.advance();
  }

  @Override
  public void settle(Map<String, Term> binding) {
    ending.settle(binding);
  }

  @Override
  public void giveUp(List<String> reasons) {
    ending.giveUp(reasons);
  }

  @Override
  public GoalStatus status() {
    return life.status(parts.activeGoals().leases().waitsOf(life.id()))
        .worth(parts.activeGoals().appraisals().find(life.id()));
  }

  @Override
  public Decisions decisions() {
    return planning.decisions();
  }

  @Override
  public boolean isHolding() {
    return life.state() == GoalState.HOLDING;
  }

  @Override
  public Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other) {
    if (life.isOver() || life.state() == GoalState.SUSPENDED) {
      return Optional.empty();
    }
    return parts
        .resourceClaims()
        .spoiledBy(
            changes,
            now,
            isHolding(),
            !life.phase().isResting() && parts.activeGoals().leases().isBefore(id(), other));
  }
}
