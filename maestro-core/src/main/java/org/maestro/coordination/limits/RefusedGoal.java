package org.maestro.coordination.limits;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.GoalOfGoals;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.GoalStory;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.knowledge.api.KnowledgeBase;

/** A goal for which nothing is done, and whose story tells why. The coordinator's thread only. */
public final class RefusedGoal implements GoalOfGoals {
  private final GoalLife life;
  private final GoalStory story;
  private final ActiveGoals activeGoals;
  private final String why;

  /**
   * @param why a sentence
   */
  public RefusedGoal(
      String id,
      GoalRequest request,
      String why,
      Ports ports,
      ActiveGoals activeGoals,
      Consumer<GoalOutcome> ended) {
    this.story = new GoalStory(id, ports.story(), ports.clock(), ports.knowledge());
    this.life = new GoalLife(id, request, ports, story, ended);
    this.activeGoals = activeGoals;
    this.why = why;
  }

  @Override
  public void start() {
    if (!life.isOver()) {
      story.submitted(life.request());
      end(GoalState.FAILED, why);
    }
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    life.become(GoalPhase.RECOVERING, awaited);
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    goal.calls().forEach(call -> former.giveUp(call, "it may not be done any more"));
    end(GoalState.FAILED, why);
  }

  @Override
  public void cancel(String who) {
    end(GoalState.CANCELLED, "Cancelled by " + who + ".");
  }

  @Override
  public void deadlinePassed() {
    end(GoalState.FAILED, why);
  }

  private void end(GoalState how, String reason) {
    if (!life.isOver()) {
      life.become(GoalPhase.ENDING);
      life.end(how, false, Map.of(), List.of(reason));
      activeGoals.leave(life.id());
    }
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    // Nothing is done for it, whatever is so.
  }

  @Override
  public String id() {
    return life.id();
  }

  @Override
  public GoalStatus status() {
    return life.status(List.of());
  }

  @Override
  public Duration pursuedSince() {
    return life.submittedAt();
  }

  @Override
  public PlanRecords plans() {
    return story.plans();
  }
}
