package org.maestro.coordination.maintenance;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.HeldNews;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Takeover;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.facts.Assured;
import org.maestro.coordination.facts.Confirmation;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.facts.WatchedKnowledge;
import org.maestro.coordination.recovery.AttemptJournal;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.PlanRecords;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;

/**
 * A goal that is held until it is cancelled: brought about ({@link HeldWork}), observed without a
 * break ({@link Watch}), restored when it is lost, and held by cheaper settings when these would do
 * ({@link Reoptimization}; Three-layered architecture, 1 and 5.1; M5, M91). The coordinator's
 * thread only.
 */
public final class MaintenanceGoal implements ActiveGoal {
  /** Facts grow too old without news; so often it is looked at in any case. */
  private static final Duration BETWEEN_LOOKS = Duration.ofSeconds(60);

  private final Wish wish;
  private final HeldCondition condition;
  private final Ports ports;
  private final Ports working;
  private final ActiveGoals activeGoals;
  private final GoalLife life;
  private final HeldStory story;
  private final Watch watch;
  private final OwnSettings settings;
  private final AttemptJournal attempts;
  private final HeldWork work;
  private final Holding holding;
  private final Suspension suspension;
  private final Reoptimization saving;
  private final NextLook nextLook;

  private Evidence evidence = Evidence.OBSERVED;
  private Duration wantingSince;

  public MaintenanceGoal(
      Wish wish,
      Ports ports,
      ActiveGoals activeGoals,
      ExactPrices exactPrices,
      Reaching reaching,
      Consumer<HeldNews> news,
      Consumer<GoalOutcome> ended) {
    this.wish = wish;
    this.activeGoals = activeGoals;
    this.condition = HeldCondition.of((Formula.Keep) wish.request().goal());
    this.ports = ports;
    this.watch = new Watch(condition.body());
    this.story = new HeldStory(wish.id(), ports);
    this.life = new GoalLife(wish.id(), wish.request(), ports, story.goal(), ended);
    this.wantingSince = life.submittedAt();
    this.settings = new OwnSettings(wish.id(), ports.journal());
    this.attempts = new AttemptJournal(wish.id(), ports.journal());
    this.working = working();
    this.work =
        new HeldWork(wish, activeGoals, reaching, this, story.goal().plans(), attempts::over);
    this.holding = new Holding(condition.closed(), life, story, ports.clock(), news);
    this.suspension = new Suspension(wish.id(), activeGoals, holding, story.goal());
    this.saving =
        new Reoptimization(
            condition,
            working,
            new CheaperSettings(
                wish.id(),
                condition.body(),
                working,
                exactPrices,
                activeGoals.experience(),
                settings),
            work,
            story,
            activeGoals,
            () -> isHolding() && work.isNone() && !suspension.isAgreed() && !life.isOver(),
            this::look);
    this.nextLook = new NextLook(wish.id(), ports, () -> activeGoals.run(this::lookAnyway));
  }

  /**
   * The world as those see and change it who work for this goal. That it is missed is told at once;
   * who comes back is noticed all the same.
   */
  private Ports working() {
    KnowledgeBase seen =
        new WatchedKnowledge(
            ports.knowledge(),
            now -> evidence == Evidence.KNOWN ? now : watch.seen(now, ports.knowledge().home()));
    return new Ports(
        seen,
        ports.planner(),
        ports.contractNet(),
        new ObservingDispatcher(ports.dispatcher(), ports.knowledge(), watch, settings),
        ports.thinking(),
        ports.owner(),
        ports.clock(),
        story::tellOfWork,
        attempts,
        Duration.ZERO,
        ports.messenger());
  }

  @Override
  public void start() {
    story.goal().submitted(life.request());
    nextLook.in(BETWEEN_LOOKS);
    bringAbout();
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    wantingSince = life.submittedAt();
    life.become(GoalPhase.RECOVERING, awaited);
    holding.takeUp(goal.memory().everHeld());
    work.bringAbout(condition.body(), working, this::broughtAbout).prepareToTakeUp(goal, awaited);
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    if (life.isOver()) {
      goal.calls().forEach(call -> former.giveUp(call, "its goal is over"));
      return;
    }
    life.become(GoalPhase.BRINGING_ABOUT);
    settings.takeUp(goal.memory().settings(), ports.knowledge().home());
    nextLook.in(BETWEEN_LOOKS);
    work.told(pursuit -> pursuit.takeUp(goal, former));
  }

  @Override
  public String id() {
    return wish.id();
  }

  @Override
  public GoalStatus status() {
    GoalStatus own =
        life.status(activeGoals.leases().waitsOf(id())).worth(activeGoals.appraisals().find(id()));
    return work.bringingAbout()
        .filter(pursuit -> !own.state().isFinal())
        .map(ActiveGoal::status)
        .map(now -> own.as(now.state(), now.detail().isEmpty() ? holding.whyAgain() : now.detail()))
        .orElse(own);
  }

  @Override
  public void cancel(String who) {
    if (!life.isOver()) {
      end(GoalState.CANCELLED, "Cancelled by " + who + ".");
    }
  }

  @Override
  public void deadlinePassed() {
    if (!life.isOver() && !holding.everWas()) {
      end(GoalState.FAILED, "Its deadline has passed" + life.standingInWords() + ".");
    }
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    work.told(pursuit -> pursuit.knowledgeChanged(change, changed));
    look();
  }

  @Override
  public void memberPresent(String member) {
    evidence = Evidence.OBSERVED;
    holding.renewed();
    look();
  }

  @Override
  public void offered(Takeover offer) {
    work.told(pursuit -> pursuit.offered(offer));
  }

  @Override
  public void givenBack(String member, String feature, String reason) {
    work.told(pursuit -> pursuit.givenBack(member, feature, reason));
  }

  @Override
  public void memberLost(String member) {
    watch.memberLost(member);
    holding.renewed();
    work.told(pursuit -> pursuit.memberLost(member));
    look();
  }

  @Override
  public void doubtOver(String member) {
    work.told(pursuit -> pursuit.doubtOver(member));
  }

  @Override
  public Decisions decisions() {
    return work.decisions();
  }

  @Override
  public PlanRecords plans() {
    return work.plans();
  }

  @Override
  public void advance() {
    work.current().ifPresentOrElse(ActiveGoal::advance, this::look);
  }

  @Override
  public StepsUnderway underway() {
    return work.current().map(ActiveGoal::underway).orElseGet(StepsUnderway::new);
  }

  @Override
  public boolean isHolding() {
    return holding.isSo() && !work.isBringingAbout();
  }

  @Override
  public Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other) {
    Optional<Formula> ofWork = work.asked(pursuit -> pursuit.countsOn(changes, now, other));
    return ofWork.isPresent() || !isHolding() || suspension.isAgreed()
        ? ofWork
        : condition.brokenBy(changes, now, ports.knowledge().home().vocabulary());
  }

  @Override
  public boolean isTied(String member) {
    return work.current().filter(pursuit -> pursuit.isTied(member)).isPresent();
  }

  @Override
  public double remainingSeconds() {
    return work.seconds(ActiveGoal::remainingSeconds);
  }

  @Override
  public OptionalDouble remainingCost() {
    return work.current().map(ActiveGoal::remainingCost).orElseGet(OptionalDouble::empty);
  }

  @Override
  public Duration pursuedSince() {
    return isHolding() ? ports.clock().now() : wantingSince;
  }

  @Override
  public double secondsOfRunningSteps() {
    return work.seconds(ActiveGoal::secondsOfRunningSteps);
  }

  @Override
  public void giveWayTo(String other) {
    work.told(pursuit -> pursuit.giveWayTo(other));
  }

  @Override
  public void stepBackFor(String other) {
    work.told(pursuit -> pursuit.stepBackFor(other));
  }

  /** Asked for only while it holds. */
  @Override
  public void standBackFor(String other) {
    work.stop();
    suspension.begin(other);
  }

  private boolean rests() {
    boolean rests = suspension.goesOn();
    if (rests && !condition.isSo(working.knowledge())) {
      noteLoss();
    }
    return rests;
  }

  private boolean isBegun() {
    return life.phase() != GoalPhase.SUBMITTED && life.phase() != GoalPhase.RECOVERING;
  }

  /** Is it so, and does it have to be done something about it? */
  private void look() {
    if (!isBegun() || life.isOver() || work.isBringingAbout() || rests()) {
      return;
    }
    if (condition.isSo(working.knowledge())) {
      if (work.isNone()) {
        holding.begins(evidence, isWitnessed());
        saveIfDue();
      }
    } else {
      work.stop();
      loses();
    }
  }

  /** What is observed all the time is not too old, however long nothing was told. */
  private boolean isWitnessed() {
    return Confirmation.needed(
            Assured.of(condition.closed(), ports.knowledge().home().vocabulary()),
            Map.of(),
            ports.knowledge().snapshot(),
            ports.knowledge().home(),
            Instant.MIN)
        .isEmpty();
  }

  private void loses() {
    noteLoss();
    Duration pause = holding.pause();
    if (pause.isZero()) {
      bringAbout();
    } else {
      holding.awaits();
      nextLook.in(pause);
    }
  }

  /** What is not so by what is observed now may only lack an observer. */
  private void noteLoss() {
    if (holding.isSo() && !condition.isSo(ports.knowledge())) {
      wantingSince = ports.clock().now();
      holding.ceases();
    }
  }

  private void bringAbout() {
    life.become(GoalPhase.BRINGING_ABOUT);
    story.begin(holding.isDespaired());
    work.bringAbout(condition.body(), working, this::broughtAbout).start();
  }

  private void broughtAbout(GoalOutcome outcome) {
    if (life.isOver()) {
      return;
    }
    if (outcome.reached() && condition.isSo(working.knowledge())) {
      saving.settled();
      holding.begins(evidence, outcome.confirmed() || isWitnessed());
    } else if (evidence == Evidence.OBSERVED && !outcome.reached()) {
      // Perhaps nobody can observe it all the time; then what is known has to do.
      evidence = Evidence.KNOWN;
      bringAbout();
    } else {
      evidence = Evidence.OBSERVED;
      holding.failed(
          outcome.reached()
              ? List.of("What was done for it has not made it so.")
              : outcome.reasons());
      nextLook.in(holding.pause());
    }
  }

  private void saveIfDue() {
    settings.compare(ports.knowledge().snapshot());
    if (!settings.isEmpty()) {
      saving.considerIfDue();
    }
  }

  private void end(GoalState how, String reason) {
    life.become(GoalPhase.ENDING);
    nextLook.cancel();
    work.stop();
    watch.end();
    life.end(how, false, Map.of(), List.of(reason));
    activeGoals.leave(id());
  }

  private void lookAnyway() {
    if (!life.isOver()) {
      nextLook.in(BETWEEN_LOOKS);
      look();
    }
  }
}
