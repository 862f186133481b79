package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.function.Supplier;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.TakeoverOffers;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.HeldElsewhere;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.Takeover;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.contention.Leases;
import org.maestro.coordination.contention.PlanUnderway;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.facts.FactFilter;
import org.maestro.coordination.facts.KnowledgeVersion;
import org.maestro.coordination.facts.ReplanTriggers;
import org.maestro.coordination.lessons.Insistence;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.GoalStory;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;

/**
 * Has the steps of a goal's plan done, and compares what is known with what the rest of the plan
 * needs. The coordinator's thread only.
 */
final class PlanFollowing {
  private final PursuitParts parts;
  private final PlanUnderway plan;
  private final StepsUnderway underway;
  private final GoalMonitor monitor;
  private final GoalLife life;
  private final GoalStory story;
  private final GoalTransitions course;
  private final StepExecution execution;
  private final Worthiness worthiness;
  private final TakeoverOffers offers = new TakeoverOffers();
  private ReplanTriggers concern;
  private long ownChange = -1;
  private KnowledgeVersion lookedAt;

  PlanFollowing(PursuitParts parts, GoalTransitions course) {
    this.parts = parts;
    this.plan = parts.plan();
    this.underway = parts.underway();
    this.monitor = parts.monitor();
    this.life = parts.life();
    this.story = parts.story();
    this.course = course;
    this.concern = monitor.concern(List.of());
    this.lookedAt = monitor.look();
    this.execution = new StepExecution(parts, this::stepEnded);
    this.worthiness = new Worthiness(parts, course);
  }

  void takeUp(ActionDispatcher.Request order) {
    execution.takeUp(order);
  }

  /** The goal is over. */
  void release(GoalState how) {
    execution.release(how);
  }

  private boolean isActive() {
    return !life.isOver() && !course.isPlanning() && plan.exists();
  }

  void adopt(Plan found, ContractNet.Round tender) {
    plan.adopt(found);
    concern = monitor.concern(found.steps());
    story.plan(life.plans(), found, monitor.isConfirming());
    worthiness.planned();
    Map<String, List<Step>> awards = new TreeMap<>();
    found.steps().forEach(s -> awards.computeIfAbsent(s.member(), m -> new ArrayList<>()).add(s));
    tender.award(awards);
    offers
        .lateBeside(found.steps())
        .filter(underway::contains)
        .forEach(step -> monitor.lessons().tooLate(step, "it takes longer than was told"));
    execution.callOffAllBut(found.steps());
    parts.resourceClaims().letGoOfWhatIsDone();
    if (monitor.isConfirming()) {
      life.become(GoalPhase.LOOKING);
    } else {
      life.become(GoalPhase.RUNNING, "");
    }
    continueOrSettle();
  }

  void knowledgeChanged(KnowledgeBase.Change change, FactFilter changed) {
    execution.knowledgeChanged(change);
    monitor.lessons().knowledgeChanged();
    if (!isActive()
        || underway.isAScript()
        || change.version() == ownChange
        || !concern.perhaps(changed)
        || lookedAt.has(change, changed)) {
      return;
    }
    if (life.phase().isResting()) {
      if (concern.ofGoal(changed) && settleIfReached()) {
        return;
      }
      if (concern.indeed(changed, monitor.presentFacts())) {
        worthiness.mayCostLess();
      }
    } else if (concern.indeed(changed, monitor.presentFacts())) {
      reconsider(() -> story.becauseOf(change));
    }
  }

  void memberLost(String member) {
    execution.memberLost(member);
    if (isActive() && plan.remaining().stream().anyMatch(step -> step.member().equals(member))) {
      course.makePlan(Optional.of(member + " is lost (" + parts.roster().absence(member) + ")"));
    }
  }

  /**
   * The goal decides by a plan from the present, in which both have their present prices. Who is at
   * it goes on meanwhile, and ends before another begins.
   */
  void offered(Takeover offer) {
    if (!isActive() || life.phase().isResting() || !parts.roster().isPresent(offer.by())) {
      return;
    }
    underway.find(offer.from(), offer.feature()).ifPresent(step -> consider(step, offer));
  }

  private void consider(Step step, Takeover offer) {
    Duration now = parts.ports().clock().now();
    Optional<String> why = offers.reason(step, story.sentence(step), offer, now);
    if (why.isEmpty()) {
      return;
    }
    monitor.lessons().offersAgain(offer.by(), offer.feature());
    underway.mayChangeHands(step);
    ExactPrices prices = parts.exactPrices();
    prices.forget(offer.by());
    prices.forget(offer.from());
    offers.priceIfLate(step, offer, now).ifPresent(p -> prices.put(step.key(), p, now, now));
    course.makePlan(why);
  }

  /** What it reports at its end has it planned again. */
  void givenBack(String member, String feature, String reason) {
    underway.find(member, feature).ifPresent(step -> story.givenBack(step, reason));
  }

  void advance() {
    Preemption preemption = parts.preemption();
    if (!isActive() || preemption.isAfterAnother() || worthiness.isWanting()) {
      return;
    }
    List<WaitsFor> obstacles = parts.resourceClaims().keepWhatIsWanted();
    if (!obstacles.isEmpty()) {
      preemption.await(parts.resourceClaims().wanted(), obstacles);
    } else if (life.phase().isResting()) {
      preemption.came(monitor.isConfirming());
      reconsider(() -> "things have changed while it waited");
    } else if (!preemption.givesWay(parts.resourceClaims().wanted())) {
      beginSteps();
    }
  }

  private void beginSteps() {
    List<WaitsFor> waits = new ArrayList<>();
    for (Step step : plan.startable()) {
      if (underway.contains(step)
          || underway.clashesWith(step)
          || underway.isHandedOver(step)
          || underway.goesAlone(step)) {
        continue;
      }
      List<WaitsFor> obstacles = parts.resourceClaims().obstacles(step);
      Optional<ActiveGoal> spoiled = heldBy(obstacles);
      if (spoiled.isPresent()) {
        leaveAlone(step, spoiled.get());
        return;
      }
      Optional<String> why = monitor.lessons().isInVain(step);
      if (why.isPresent()) {
        course.makePlan(why);
        return;
      }
      if (obstacles.isEmpty()) {
        begin(step);
      } else {
        waits.addAll(obstacles);
      }
    }
    if (waits.isEmpty()) {
      parts.activeGoals().leases().stopWaiting(life.id());
    } else {
      parts.preemption().awaitForStep(waits);
    }
  }

  /** A wish that is kept has no end to wait for. */
  private Optional<ActiveGoal> heldBy(List<WaitsFor> obstacles) {
    return obstacles.stream()
        .flatMap(obstacle -> parts.activeGoals().find(obstacle.holder()).stream())
        .filter(ActiveGoal::isHolding)
        .findFirst();
  }

  private void leaveAlone(Step step, ActiveGoal holding) {
    Leases leases = parts.activeGoals().leases();
    if (leases.ownStanding(life.id()).outranks(leases.ownStanding(holding.id()))) {
      holding.standBackFor(life.id());
      advance();
    } else {
      monitor.lessons().leaveAlone(step, holding.id());
      course.makePlan(
          Optional.of(
              "%s would end what %s keeps (%s)"
                  .formatted(story.sentence(step), holding.id(), holding.status().goal())));
    }
  }

  private void begin(Step step) {
    boolean owed = parts.ports().dispatcher().isOwed(parts.id(), step.key());
    if (!owed) {
      life.countCall();
    }
    if (life.state() == GoalState.WAITING) {
      life.become(monitor.isConfirming() ? GoalPhase.LOOKING : GoalPhase.RUNNING, "");
    }
    if (owed) {
      story.askedAgain(step);
    } else {
      story.begun(step, plan.size());
    }
    offers.begun(step, parts.ports().clock().now());
    execution.begin(step, plan.remaining());
  }

  /** Another manager has what the step needs: it is begun when it is free. */
  private void isHeldElsewhere(Step step, HeldElsewhere by) {
    story.heldElsewhere(step, by);
    parts
        .activeGoals()
        .otherManagers()
        .have(step.member(), Set.copyOf(step.feature().occupies()), by);
    if (plan.exists()) {
      advance();
    } else if (!course.isPlanning() && underway.isEmpty()) {
      course.makePlan(Optional.of("what was under way has ended"));
    }
  }

  private void stepEnded(StepEnd ended) {
    if (!ended.change().facts().isEmpty()) {
      ownChange = ended.change().version();
    }
    if (ended.report().heldBy().isPresent()) {
      isHeldElsewhere(ended.step(), ended.report().heldBy().get());
      return;
    }
    List<Insistence> insisted = List.of();
    if (ended.report().succeeded()) {
      plan.done(ended.step());
      worthiness.advanced();
      monitor
          .lessons()
          .done(ended.step(), ended.factsBefore(), ended.begun(), ended.report().outputs());
      story.done(ended.step(), ended.change());
    } else if (!ended.calledOff()) {
      String problem = ended.report().problem().orElse("no reason given");
      insisted = monitor.lessons().failed(ended, problem);
      story.failed(ended.step(), problem, ended.change());
      story.insists(ended.step(), insisted);
    }
    parts.resourceClaims().letGoOfWhatIsDone();
    if (course.isPlanning()) {
      course.makePlanAgain("meanwhile " + story.becauseOf(ended.step(), ended.change()));
    } else if (plan.exists() && !insisted.isEmpty()) {
      course.makePlan(said(ended));
    } else if (plan.exists()) {
      reconsider(() -> said(ended).orElseGet(() -> becauseOf(ended)));
    } else if (underway.isEmpty()) {
      course.makePlan(Optional.of("what was under way has ended"));
    }
  }

  private static Optional<String> said(StepEnd ended) {
    return ended.report().problem().map(problem -> Sentences.said(ended.step().member(), problem));
  }

  private String becauseOf(StepEnd ended) {
    return ended.change().facts().isEmpty() && plan.remaining().isEmpty()
        ? story.endedInVain()
        : story.becauseOf(ended.step(), ended.change());
  }

  /**
   * Is the rest of the plan still good, from what is known now? What a script does on its way is no
   * matter of the plan that it is a step of: it is looked at when it has ended.
   */
  private void reconsider(Supplier<String> why) {
    if (underway.isAScript()) {
      return;
    }
    lookedAt = monitor.look();
    Optional<Plan> reached = monitor.holds();
    if (reached.isPresent()) {
      if (underway.isEmpty()) {
        course.settle(reached.get().goalBinding());
      }
      return;
    }
    List<Step> remaining = plan.remaining();
    Optional<Step> unable =
        remaining.stream().filter(step -> !parts.roster().isPresent(step.member())).findFirst();
    if (unable.isPresent()) {
      course.makePlan(Optional.of(parts.roster().absence(unable.get().member())));
    } else if (remaining.isEmpty() || !monitor.isGood(remaining)) {
      course.makePlan(Optional.of(why.get() + blockedStep(remaining)));
    } else {
      continueOrSettle();
    }
  }

  private String blockedStep(List<Step> remaining) {
    return monitor
        .blocked(remaining)
        .map(
            step ->
                "; step %d (%s) is not possible so".formatted(step.number(), story.sentence(step)))
        .orElse("");
  }

  private void continueOrSettle() {
    if (!plan.remaining().isEmpty() || !settleIfReached()) {
      advance();
    }
  }

  private boolean settleIfReached() {
    Optional<Plan> reached = monitor.holds().filter(plan -> underway.isEmpty());
    reached.ifPresent(plan -> course.settle(plan.goalBinding()));
    return reached.isPresent();
  }
}
