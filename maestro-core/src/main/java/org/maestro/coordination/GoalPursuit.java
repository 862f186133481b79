package org.maestro.coordination;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import java.util.function.Consumer;
import java.util.function.Supplier;
import org.maestro.knowledge.KnowledgeBase;
import org.maestro.knowledge.Snapshot;
import org.maestro.planning.Plan;
import org.maestro.planning.PlanningResult;
import org.maestro.planning.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * What one goal does next: plan, award, have steps done, compare what is known with what the plan
 * needs, plan again, have it seen, end. The coordinator's thread only.
 */
final class GoalPursuit implements Pursuit {
  private static final int MOST_PLANS = 60;

  /** Looks that do not show it, again and again, show nothing either. */
  private static final int MOST_CONFIRMATIONS = 10;

  private final Ports ports;
  private final Roster roster;
  private final Rivals rivals;
  private final ExactPrices exactPrices;
  private final GoalStory story;
  private final GoalLife life;
  private final PlanUnderway plan = new PlanUnderway();
  private final StepsUnderway underway = new StepsUnderway();
  private final Outlook outlook;
  private final LastTry lastTry;
  private final Contention contention;
  private final Turn turn;
  private final StepExecution execution;
  private Optional<String> planAgain = Optional.empty();
  private Optional<Decision> decision = Optional.empty();
  private Concern concern;
  private long ownChange = -1;
  private Interest changedMeanwhile;
  private boolean planning;

  GoalPursuit(
      String id,
      GoalRequest request,
      Ports ports,
      Roster roster,
      Rivals rivals,
      ExactPrices exactPrices,
      Consumer<GoalOutcome> ended) {
    this.ports = ports;
    this.roster = roster;
    this.rivals = rivals;
    this.exactPrices = exactPrices;
    this.story = new GoalStory(id, ports.story(), ports.clock(), ports.knowledge());
    this.life = new GoalLife(id, request, ports, story, ended);
    this.changedMeanwhile = new Interest(ports.knowledge().home().vocabulary());
    this.outlook = new Outlook(id, request, ports, rivals);
    this.lastTry = new LastTry(ports, rivals, outlook);
    this.concern = concern(List.of());
    this.contention = new Contention(id, request, ports, rivals, plan, underway);
    this.turn = new Turn(life, story, rivals, contention, underway);
    this.execution =
        new StepExecution(
            id,
            ports,
            rivals,
            contention,
            exactPrices,
            story,
            underway,
            outlook::factsUnder,
            this::stepEnded);
  }

  @Override
  public void start() {
    if (!life.isOver()) {
      story.submitted(life.request());
      makePlan(Optional.empty());
    }
  }

  @Override
  public String id() {
    return life.id();
  }

  @Override
  public void prepareToTakeUp(Recovery.UnfinishedGoal goal, String awaited) {
    life.takeUp(goal);
    contention.takeUp(goal.keeps());
    life.become(GoalState.WAITING, awaited);
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    if (life.isOver()) {
      goal.calls().forEach(call -> former.giveUp(call, "its goal was cancelled"));
      return;
    }
    story.takenUp(goal);
    for (Recovery.UnfinishedCall call : goal.calls()) {
      Optional<String> obstacle = former.obstacle(call);
      story.takenUp(call, obstacle);
      if (obstacle.isPresent()) {
        former.giveUp(call, obstacle.get());
      } else {
        execution.takeUp(former.order(call));
      }
    }
    if (underway.isEmpty()) {
      makePlan(
          goal.effort().plans() == 0
              ? Optional.empty()
              : Optional.of("the coordinator was started again"));
    } else {
      life.become(GoalState.WAITING, "what was under way before the restart has to end first");
    }
  }

  @Override
  public GoalStatus status() {
    return life.status(rivals.leases().waitsOf(life.id()));
  }

  @Override
  public StepsUnderway underway() {
    return underway;
  }

  @Override
  public void cancel(String who) {
    if (!life.isOver()) {
      end(GoalState.CANCELLED, false, Map.of(), List.of("Cancelled by " + who + "."));
    }
  }

  @Override
  public void deadlinePassed() {
    if (!life.isOver()) {
      end(
          GoalState.FAILED,
          false,
          Map.of(),
          List.of("Its deadline has passed" + life.standingInWords() + "."));
    }
  }

  @Override
  public void knowledgeChanged(KnowledgeBase.Change change, Interest changed) {
    if (planning) {
      changedMeanwhile.addAll(changed);
    }
    if (!isFollowingPlan() || change.version() == ownChange) {
      return;
    }
    if (turn.isAwaited()) {
      if (concern.ofGoal(changed)) {
        settleIfReached();
      }
    } else if (concern.indeed(changed, outlook.presentFacts())) {
      reconsider(() -> story.becauseOf(change));
    }
  }

  private Concern concern(List<Step> steps) {
    return new Concern(
        life.request().goal(),
        steps,
        ports.knowledge().home().vocabulary(),
        outlook.presentFacts());
  }

  @Override
  public void memberLost(String member) {
    if (isFollowingPlan()
        && plan.remaining().stream().anyMatch(step -> step.member().equals(member))) {
      makePlan(Optional.of(member + " is lost (" + roster.absence(member) + ")"));
    }
  }

  @Override
  public void advance() {
    if (!isFollowingPlan() || turn.isAfterAnother()) {
      return;
    }
    List<WaitsFor> obstacles = contention.keepWhatIsWanted();
    if (!obstacles.isEmpty()) {
      turn.await(contention.wanted(), obstacles);
    } else if (turn.isAwaited()) {
      turn.came(outlook.isConfirming());
      reconsider(() -> "things have changed while it waited");
    } else if (!turn.givesWay(contention.wanted())) {
      beginSteps();
    }
  }

  private void beginSteps() {
    List<WaitsFor> waits = new ArrayList<>();
    for (Step step : plan.startable()) {
      if (underway.contains(step) || underway.clashesWith(step)) {
        continue;
      }
      List<WaitsFor> obstacles = contention.obstacles(step);
      Optional<Pursuit> spoiled = heldBy(obstacles);
      if (spoiled.isPresent()) {
        leaveAlone(step, spoiled.get());
        return;
      }
      if (obstacles.isEmpty()) {
        begin(step);
      } else {
        waits.addAll(obstacles);
      }
    }
    if (waits.isEmpty()) {
      rivals.leases().stopWaiting(id());
    } else {
      turn.awaitForStep(waits);
    }
  }

  /** A wish that is kept has no end to wait for. */
  private Optional<Pursuit> heldBy(List<WaitsFor> obstacles) {
    return obstacles.stream()
        .flatMap(obstacle -> rivals.find(obstacle.holder()).stream())
        .filter(Pursuit::isHolding)
        .findFirst();
  }

  private void leaveAlone(Step step, Pursuit holding) {
    if (priority() > holding.priority()) {
      holding.standBackFor(id());
      advance();
    } else {
      outlook.leaveAlone(step, holding.id());
      makePlan(
          Optional.of(
              "%s would end what %s keeps (%s)"
                  .formatted(story.sentence(step), holding.id(), holding.status().goal())));
    }
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
    return contention.spoiledBy(
        changes, now, isHolding(), !turn.isAwaited() && rivals.leases().isBefore(id(), other));
  }

  @Override
  public boolean isTied(String member) {
    return contention.isTied(member);
  }

  @Override
  public double remainingSeconds() {
    return plan.remaining().stream().mapToDouble(Step::seconds).sum();
  }

  @Override
  public double secondsOfRunningSteps() {
    return underway.steps().stream().mapToDouble(Step::seconds).max().orElse(0);
  }

  @Override
  public void giveWayTo(String other) {
    turn.giveWay(other);
  }

  @Override
  public void standBackFor(String other) {
    turn.standBackFor(other);
  }

  @Override
  public void stepBackFor(String other) {
    turn.stepBackFor(other);
  }

  @Override
  public int priority() {
    return life.request().priority();
  }

  private boolean isFollowingPlan() {
    return !life.isOver() && !planning && plan.exists();
  }

  private void begin(Step step) {
    life.countCall();
    if (life.state() == GoalState.WAITING) {
      life.become(outlook.isConfirming() ? GoalState.CONFIRMING : GoalState.RUNNING, "");
    }
    story.begun(step, plan.size());
    execution.begin(step);
  }

  private void makePlan(Optional<String> why) {
    if (planning) {
      planAgain = why;
      return;
    }
    if (outlook.isConfirming() && life.confirmingPlans() >= MOST_CONFIRMATIONS) {
      plan.drop();
      noPlanToSeeIt();
      return;
    }
    if (life.plans() >= MOST_PLANS) {
      giveUp(List.of("It was planned " + life.plans() + " times without getting there; given up."));
      return;
    }
    planning = true;
    changedMeanwhile = new Interest(ports.knowledge().home().vocabulary());
    turn.forget();
    life.countPlan(outlook.isConfirming());
    life.become(stateWhilePlanning(why), why.orElse(""));
    story.planning(life.plans(), why);
    new PlanMaking(
            id(),
            ports,
            roster,
            exactPrices,
            outlook,
            rivals,
            contention,
            story,
            round -> rivals.run(() -> planned(round)))
        .start();
  }

  private GoalState stateWhilePlanning(Optional<String> why) {
    if (outlook.isConfirming()) {
      return GoalState.CONFIRMING;
    }
    return why.isPresent() ? GoalState.REPLANNING : GoalState.PLANNING;
  }

  /** While it was planned how to see it, somebody told: nothing is left to be looked for. */
  private boolean isSeenMeanwhile() {
    return outlook.isConfirming()
        && underway.isEmpty()
        && outlook.holds().filter(p -> outlook.toBeSeen(p.goalBinding()).isEmpty()).isPresent();
  }

  private void planned(PlanningRound.Ended round) {
    planning = false;
    if (life.isOver()) {
      round.tender().award(Map.of());
      return;
    }
    outlook.offered(round.features());
    if (isSeenMeanwhile()) {
      round.tender().award(Map.of());
      settle(outlook.holds().orElseThrow().goalBinding());
      return;
    }
    story.bids(round.tender().bids(), round.questions(), round.unpriced());
    Optional<String> why = planAgain.or(() -> changedMeanwhile(round.result()));
    planAgain = Optional.empty();
    if (why.isPresent() && !isStillGood(round.result())) {
      round.tender().award(Map.of());
      makePlan(why);
    } else if (round.result() instanceof PlanningResult.Found found) {
      found.atLeast().ifPresent(atLeast -> story.notProven(atLeast, found.plan()));
      note(found.plan(), round);
      adopt(found.plan(), round.tender());
    } else {
      round.tender().award(Map.of());
      noPlan(round);
    }
  }

  private Optional<String> changedMeanwhile(PlanningResult result) {
    return result instanceof PlanningResult.Found found
            && concern(found.plan().steps()).perhaps(changedMeanwhile)
        ? Optional.of("things have changed while it was planned")
        : Optional.empty();
  }

  /** Something happened while it was planned: is the plan the right one all the same? */
  private boolean isStillGood(PlanningResult result) {
    return result instanceof PlanningResult.Found found
        && found.plan().steps().stream().allMatch(step -> roster.isPresent(step.member()))
        && outlook.isGood(found.plan().steps());
  }

  private void note(Plan found, PlanningRound.Ended round) {
    if (!outlook.isConfirming() && !found.steps().isEmpty()) {
      decision =
          Optional.of(new Decision(round.task(), found, round.tender().bids(), round.questions()));
    }
  }

  @Override
  public Optional<Decision> decision() {
    return decision;
  }

  private void adopt(Plan found, Market.Tender tender) {
    plan.adopt(found);
    concern = concern(found.steps());
    story.plan(life.plans(), found, outlook.isConfirming());
    Map<String, List<Step>> parts = new TreeMap<>();
    found.steps().forEach(s -> parts.computeIfAbsent(s.member(), m -> new ArrayList<>()).add(s));
    tender.award(parts);
    execution.callOffAllBut(found.steps());
    contention.letGoOfWhatIsDone();
    if (!outlook.isConfirming()) {
      life.become(GoalState.RUNNING, "");
    }
    continueOrSettle();
  }

  private void noPlan(PlanningRound.Ended round) {
    plan.drop();
    contention.letGo();
    if (!underway.isEmpty()) {
      life.become(GoalState.WAITING, "what is under way has to end first");
      return;
    }
    if (outlook.isConfirming()) {
      noPlanToSeeIt();
    } else if (lastTry.isLeft(round)) {
      life.become(GoalState.WAITING, "what failed or was not priced is tried once more");
      story.triesOnceMore(LastTry.PAUSE, round.result());
      lastTry.afterPause(this::tryOnceMore);
    } else {
      List<String> reasons = new ArrayList<>(outlook.reasonsOfLeavingAlone());
      reasons.addAll(story.reasons(round.result()));
      round.notCountedOn().ifPresent(reasons::add);
      giveUp(reasons);
    }
  }

  private void tryOnceMore() {
    if (!life.isOver()) {
      makePlan(Optional.of("what failed or was not priced may be possible now"));
    }
  }

  /** Ends it, with what was looked at in vain and what could not be looked at. */
  private void giveUp(List<String> reasons) {
    SearchReview review = outlook.searchReview(roster);
    ports
        .thinking()
        .think(
            () -> review.reports(life.request().goal()),
            reports -> rivals.run(() -> gaveUp(reasons, reports)));
  }

  private void gaveUp(List<String> reasons, List<SearchReport> reports) {
    if (!life.isOver()) {
      List<String> all = new ArrayList<>(reasons);
      reports.forEach(report -> all.addAll(story.searched(report)));
      execution.release();
      life.end(GoalState.FAILED, false, Map.of(), all, reports);
      rivals.leave(id());
    }
  }

  private void noPlanToSeeIt() {
    Optional<Plan> reached = outlook.holds();
    if (reached.isPresent()) {
      story.unconfirmed();
      end(GoalState.ACHIEVED, false, reached.get().goalBinding(), List.of());
    } else {
      outlook.confirm(Optional.empty());
      makePlan(Optional.of("it cannot be seen any more that the goal is reached"));
    }
  }

  private void stepEnded(StepExecution.Ended ended) {
    if (!ended.change().facts().isEmpty()) {
      ownChange = ended.change().version();
    }
    if (ended.report().succeeded()) {
      plan.done(ended.step());
      outlook.done(ended.step(), ended.report().outputs());
      story.done(ended.step(), ended.change());
    } else if (!ended.calledOff()) {
      String problem = ended.report().problem().orElse("no reason given");
      outlook.failed(ended.step(), ended.factsBefore(), problem);
      story.failed(ended.step(), problem, ended.change());
    }
    contention.letGoOfWhatIsDone();
    if (planning) {
      planAgain = Optional.of("meanwhile " + story.becauseOf(ended.change()));
    } else if (plan.exists()) {
      reconsider(() -> ended.report().problem().orElseGet(() -> story.becauseOf(ended.change())));
    } else if (underway.isEmpty()) {
      makePlan(Optional.of("what was under way has ended"));
    }
  }

  /** Is the rest of the plan still good, from what is known now? */
  private void reconsider(Supplier<String> why) {
    Optional<Plan> reached = outlook.holds();
    if (reached.isPresent()) {
      if (underway.isEmpty()) {
        settle(reached.get().goalBinding());
      }
      return;
    }
    List<Step> remaining = plan.remaining();
    Optional<Step> unable =
        remaining.stream().filter(step -> !roster.isPresent(step.member())).findFirst();
    if (unable.isPresent()) {
      makePlan(Optional.of(roster.absence(unable.get().member())));
    } else if (remaining.isEmpty() || !outlook.isGood(remaining)) {
      makePlan(Optional.of(why.get() + blockedStep(remaining)));
    } else {
      continueOrSettle();
    }
  }

  private void settleIfReached() {
    Optional<Plan> reached = outlook.holds();
    if (reached.isPresent() && underway.isEmpty()) {
      settle(reached.get().goalBinding());
    }
  }

  private String blockedStep(List<Step> remaining) {
    return outlook
        .blocked(remaining)
        .map(
            step ->
                "; step %d (%s) is not possible so".formatted(step.number(), story.sentence(step)))
        .orElse("");
  }

  private void continueOrSettle() {
    if (plan.remaining().isEmpty()) {
      Optional<Plan> reached = outlook.holds();
      if (reached.isPresent() && underway.isEmpty()) {
        settle(reached.get().goalBinding());
        return;
      }
    }
    advance();
  }

  /** The goal holds by what is known: end, or have it seen first. */
  private void settle(Map<String, Term> binding) {
    Optional<Confirmation> needed = outlook.toBeSeen(binding);
    if (needed.isEmpty()) {
      story.confirmed(life.request().goal(), binding);
      end(GoalState.ACHIEVED, true, binding, List.of());
    } else if (!outlook.isConfirming()) {
      outlook.confirm(needed);
      plan.drop();
      story.confirming(needed.get());
      makePlan(Optional.empty());
    } else if (underway.isEmpty() && plan.remaining().isEmpty()) {
      outlook.confirm(needed);
      makePlan(Optional.of("it was not seen"));
    } else {
      advance();
    }
  }

  private void end(
      GoalState how, boolean confirmed, Map<String, Term> binding, List<String> reasons) {
    execution.release();
    life.end(how, confirmed, binding, reasons);
    rivals.leave(id());
  }
}
