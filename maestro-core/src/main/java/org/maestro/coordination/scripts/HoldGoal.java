package org.maestro.coordination.scripts;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.Leases;
import org.maestro.coordination.contention.StandingBack;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.GoalStory;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;

/**
 * A component that is held while steps of a script are done: a goal that waits for it as any goal
 * does, and gives way where none of these steps is using it. What gave way takes it again
 * afterwards; its steps go on meanwhile with what they can have. The coordinator's thread only.
 */
final class HoldGoal implements ActiveGoal {
  private final Resource wanted;
  private final GoalLife life;
  private final GoalStory story;
  private final ActiveGoals activeGoals;
  private final Journal journal;
  private final Runnable held;
  private final StandingBack standingBack;
  private boolean isHeld;
  private boolean wasHeld;
  private boolean hasWaited;

  /**
   * @param held run once, when it is held for the first time
   */
  HoldGoal(
      String id,
      GoalRequest request,
      Resource wanted,
      Ports ports,
      ActiveGoals activeGoals,
      Runnable held,
      Consumer<GoalOutcome> ended) {
    this.wanted = wanted;
    this.activeGoals = activeGoals;
    this.journal = ports.journal();
    this.held = held;
    this.standingBack = new StandingBack(id, activeGoals);
    this.story = new GoalStory(id, ports.story(), ports.clock(), ports.knowledge());
    this.life = new GoalLife(id, request, ports, story, ended);
  }

  private Leases leases() {
    return activeGoals.leases();
  }

  @Override
  public void start() {
    advance();
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    life.become(GoalPhase.RECOVERING, awaited);
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    advance();
  }

  @Override
  public void advance() {
    if (life.isOver() || isHeld || standingBack.isSo()) {
      return;
    }
    List<WaitsFor> obstacles = leases().obstaclesToKeep(id(), Set.of(wanted));
    if (obstacles.isEmpty()) {
      take();
    } else {
      await(obstacles);
    }
  }

  private void take() {
    leases().stopWaiting(id());
    standingBack.forget();
    leases().hold(id(), Set.of(wanted));
    isHeld = true;
    writeDown();
    life.become(GoalPhase.CARRYING_OUT, "");
    if (hasWaited) {
      hasWaited = false;
      story.goesOn();
    }
    if (!wasHeld) {
      wasHeld = true;
      held.run();
    }
  }

  private void await(List<WaitsFor> obstacles) {
    leases().waitFor(id(), Set.of(wanted), obstacles);
    if (life.state() != GoalState.SUSPENDED) {
      life.becomeIfNew(
          GoalPhase.WAITING_FOR_TURN,
          obstacles.stream().map(WaitsFor::inWords).distinct().collect(Collectors.joining(", ")));
      if (!hasWaited) {
        story.waits(obstacles);
      }
    }
    hasWaited = true;
    activeGoals.askForWay(id(), obstacles);
    activeGoals.breakCircle(id());
  }

  private void writeDown() {
    journal.write(
        new JournalEntry.Keeps(id(), isHeld ? Set.of(wanted) : Set.of(), Set.of(), Map.of()));
  }

  /** Its steps are done. */
  void finish() {
    end(GoalState.ACHIEVED, List.of());
  }

  @Override
  public void cancel(String who) {
    end(GoalState.CANCELLED, List.of("Cancelled by " + who + "."));
  }

  @Override
  public void deadlinePassed() {
    end(GoalState.FAILED, List.of("Its deadline has passed" + life.standingInWords() + "."));
  }

  private void end(GoalState how, List<String> reasons) {
    if (!life.isOver()) {
      life.become(GoalPhase.ENDING);
      isHeld = false;
      life.end(how, how == GoalState.ACHIEVED, Map.of(), reasons);
      activeGoals.leave(id());
    }
  }

  /** It is asked again as soon as the step that uses it has ended. */
  @Override
  public void giveWayTo(String other) {
    activeGoals.run(
        () -> {
          boolean isWanted =
              leases().waitsOf(other).stream()
                  .anyMatch(edge -> edge.holder().equals(id()) && edge.resource().equals(wanted));
          if (isWanted) {
            letGo(
                other,
                "%s goes first with %s%s"
                    .formatted(other, wanted.inWords(), activeGoals.whyFirst(other, id())),
                Set.of(wanted),
                standingBack::untilWayOf);
          }
        });
  }

  @Override
  public void standBackFor(String other) {
    letGo(
        other,
        other + " goes first" + activeGoals.whyFirst(other, id()),
        Set.of(),
        standingBack::untilEndOf);
  }

  @Override
  public void stepBackFor(String other) {
    standBackFor(other);
  }

  /**
   * @param queued what it stands in the queue for meanwhile
   */
  private void letGo(String other, String why, Set<Resource> queued, Consumer<String> standsBack) {
    if (life.isOver() || !isHeld || leases().isUsedWithin(id(), Set.of(wanted))) {
      return;
    }
    isHeld = false;
    hasWaited = true;
    standsBack.accept(other);
    List<WaitsFor> edges = new ArrayList<>();
    queued.forEach(resource -> edges.add(new WaitsFor(id(), resource, other)));
    edges.add(new WaitsFor(id(), Resource.endOf(other), other));
    leases().waitFor(id(), queued, edges);
    life.become(GoalPhase.SUSPENDED, why);
    story.suspended(why);
    leases().release(id());
    writeDown();
  }

  @Override
  public String id() {
    return life.id();
  }

  @Override
  public GoalStatus status() {
    return life.status(leases().waitsOf(id()));
  }

  @Override
  public Decisions decisions() {
    return new Decisions();
  }

  @Override
  public PlanRecords plans() {
    return story.plans();
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    // What is held is held whatever is known.
  }

  /** Who is lost may come back, and is still to be nobody else's then. */
  @Override
  public void memberLost(String member) {
    // The steps that need it hear of it themselves.
  }

  @Override
  public StepsUnderway underway() {
    return new StepsUnderway();
  }

  @Override
  public boolean isHolding() {
    return false;
  }

  @Override
  public Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other) {
    return Optional.empty();
  }

  @Override
  public boolean isTied(String member) {
    return member.equals(wanted.owner()) && leases().isUsedWithin(id(), Set.of(wanted));
  }

  /** Nobody knows how long it is held. */
  @Override
  public double remainingSeconds() {
    return isHeld ? Double.POSITIVE_INFINITY : 0;
  }

  @Override
  public OptionalDouble remainingCost() {
    return OptionalDouble.empty();
  }

  @Override
  public Duration pursuedSince() {
    return life.submittedAt();
  }

  @Override
  public double secondsOfRunningSteps() {
    return 0;
  }
}
