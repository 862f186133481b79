package org.maestro.coordination.agenda;

import java.time.Duration;
import java.util.List;
import java.util.Optional;
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
import org.maestro.sl.Formula;
import org.maestro.sl.Occasion;
import org.maestro.sl.SlPrinter;

/**
 * A goal that is bound to a time or an event, and begins other goals then, which contend with
 * others as any goal does. The coordinator's thread only.
 */
public final class EntryGoal implements GoalOfGoals {
  private final GoalLife life;
  private final GoalStory story;
  private final Entry entry;
  private final Vigil vigil;
  private Optional<Runnable> onceRecovered = Optional.empty();

  /**
   * @param request its goal is bound
   */
  public EntryGoal(
      String id,
      GoalRequest request,
      Ports ports,
      ActiveGoals activeGoals,
      Beginnings goals,
      Consumer<GoalOutcome> ended) {
    this.story = new GoalStory(id, ports.story(), ports.clock(), ports.knowledge());
    this.life = new GoalLife(id, request, ports, story, ended);
    this.entry = new Entry(life, ports, activeGoals, goals);
    this.vigil = vigil((Formula.Bound) request.goal());
  }

  private Vigil vigil(Formula.Bound bound) {
    if (bound instanceof Formula.Until until) {
      return new UntilThen(entry, until);
    } else if (bound.occasion() instanceof Occasion.Event event) {
      return event.again()
          ? new Whenever(entry, event.condition(), bound.goal())
          : new AsSoonAs(entry, event.condition(), bound.goal());
    }
    Due due = new Due(bound.occasion(), entry);
    if (bound.occasion() instanceof Occasion.At at && at.again()) {
      return new Again(entry, due, bound.goal());
    }
    return new Once(entry, due, bound.goal());
  }

  @Override
  public void start() {
    if (!life.isOver()) {
      story.submitted(life.request(), SlPrinter.print(life.request().goal()));
      vigil.start();
    }
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    life.become(GoalPhase.RECOVERING, awaited);
    entry.takeUp(goal.memory().notes());
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    if (!entry.isEnding()) {
      story.takenUp(goal);
      vigil.takeUp();
      onceRecovered.ifPresent(Runnable::run);
    }
  }

  @Override
  public void cancel(String who) {
    end(GoalState.CANCELLED, "Cancelled by " + who + ".");
  }

  @Override
  public void deadlinePassed() {
    end(GoalState.FAILED, "Its deadline has passed" + life.standingInWords() + ".");
  }

  /** What it has begun before a restart is known to it once it was taken up. */
  private void end(GoalState how, String reason) {
    if (life.phase() == GoalPhase.RECOVERING) {
      onceRecovered = Optional.of(() -> end(how, reason));
    } else {
      entry.end(how, reason, life.id());
    }
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    if (!entry.isEnding()) {
      vigil.knowledgeChanged(changed);
    }
  }

  @Override
  public void memberLost(String member) {
    if (!entry.isEnding()) {
      vigil.memberLost();
    }
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
