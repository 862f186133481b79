package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanPurpose;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.GoalStory;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;

/**
 * A pursuit by plans whose steps are followed: what all such goals are to others beside them. The
 * coordinator's thread only.
 */
abstract class PlannedPursuit implements ActiveGoal, GoalTransitions {
  final PursuitParts parts;
  final GoalLife life;
  final PlanFollowing following;

  /**
   * @param deeds what was done for the goal before, when it is tried again
   * @param purpose what its plans are made for
   */
  PlannedPursuit(
      String id,
      GoalRequest request,
      Ports ports,
      Roster roster,
      ActiveGoals activeGoals,
      ExactPrices exactPrices,
      VainDeeds deeds,
      PlanPurpose purpose,
      Consumer<GoalOutcome> ended) {
    GoalStory story = new GoalStory(id, ports.story(), ports.clock(), ports.knowledge());
    this.life = new GoalLife(id, request, ports, story, ended);
    this.parts =
        PursuitParts.of(life, story, ports, roster, activeGoals, exactPrices, deeds, purpose);
    this.following = new PlanFollowing(parts, this);
  }

  /** Ends it, if it is not over, with nothing that would have to be seen first. */
  final void end(GoalState how, List<String> reasons) {
    if (!life.isOver()) {
      life.become(GoalPhase.ENDING);
      following.release(how);
      life.end(how, false, Map.of(), reasons);
      parts.activeGoals().leave(life.id());
    }
  }

  @Override
  public final String id() {
    return life.id();
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    parts.resourceClaims().takeUp(goal.keeps());
    parts.monitor().lessons().takeUp(goal.memory());
    life.become(GoalPhase.RECOVERING, awaited);
  }

  @Override
  public GoalStatus status() {
    return life.status(parts.activeGoals().leases().waitsOf(life.id()));
  }

  @Override
  public PlanRecords plans() {
    return parts.story().plans();
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    following.knowledgeChanged(change, changed);
  }

  @Override
  public void memberLost(String member) {
    following.memberLost(member);
  }

  @Override
  public void givenBack(String member, String feature, String reason) {
    following.givenBack(member, feature, reason);
  }

  @Override
  public boolean isPlanning() {
    return life.phase().isPlanning();
  }

  @Override
  public void adopt(Plan found, ContractNet.Round tender) {
    following.adopt(found, tender);
  }

  @Override
  public void advance() {
    following.advance();
  }

  @Override
  public StepsUnderway underway() {
    return parts.underway();
  }

  @Override
  public boolean isHolding() {
    return false;
  }

  @Override
  public boolean isTied(String member) {
    return parts.resourceClaims().isTied(member);
  }

  @Override
  public double remainingSeconds() {
    return parts.plan().remaining().stream().mapToDouble(Step::seconds).sum();
  }

  @Override
  public OptionalDouble remainingCost() {
    return parts.plan().exists()
        ? OptionalDouble.of(parts.plan().remaining().stream().mapToDouble(Step::cost).sum())
        : OptionalDouble.empty();
  }

  @Override
  public Duration pursuedSince() {
    return life.submittedAt();
  }

  @Override
  public double secondsOfRunningSteps() {
    return parts.underway().steps().stream().mapToDouble(Step::seconds).max().orElse(0);
  }

  @Override
  public void giveWayTo(String other) {
    parts.preemption().giveWay(other);
  }

  @Override
  public void standBackFor(String other) {
    parts.preemption().standBackFor(other);
  }

  @Override
  public void stepBackFor(String other) {
    parts.preemption().stepBackFor(other);
  }
}
