package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.api.ActionDispatcher;
import org.maestro.coordination.api.Argument;
import org.maestro.coordination.api.CallArguments;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.contention.ResourceClaims;
import org.maestro.coordination.contention.StepsUnderway;
import org.maestro.coordination.facts.Confirmation;
import org.maestro.coordination.facts.NextPlace;
import org.maestro.coordination.facts.Sensing;
import org.maestro.coordination.lessons.Experience;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalStory;
import org.maestro.knowledge.api.FeatureRun;
import org.maestro.knowledge.api.KnowledgeBase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.knowledge.api.StepAccount;
import org.maestro.knowledge.learning.ResultCheck;
import org.maestro.planning.api.Step;
import org.maestro.planning.api.StepKey;
import org.maestro.sl.Effect;
import org.maestro.sl.Term;

/** Has one goal's steps done: takes what they occupy, orders them, learns from their reports. */
final class StepExecution {
  /** What the bus may take, which no fast clock makes shorter. */
  private static final Duration ON_THE_BUS = Duration.ofSeconds(15);

  private final String goalId;
  private final Ports ports;
  private final Roster roster;
  private final ActiveGoals activeGoals;
  private final ResourceClaims resourceClaims;
  private final ExactPrices exactPrices;
  private final GoalLife life;
  private final GoalStory story;
  private final StepsUnderway underway;
  private final GoalMonitor monitor;
  private final Consumer<StepEnd> ended;
  private final StandingConditions standing;
  private final LaterEffects laterEffects;
  private final List<Established> established = new ArrayList<>();

  private record Established(Step step, ActionDispatcher.Handle performance) {}

  StepExecution(PursuitParts parts, Consumer<StepEnd> ended) {
    this.goalId = parts.id();
    this.ports = parts.ports();
    this.roster = parts.roster();
    this.activeGoals = parts.activeGoals();
    this.resourceClaims = parts.resourceClaims();
    this.exactPrices = parts.exactPrices();
    this.life = parts.life();
    this.story = parts.story();
    this.underway = parts.underway();
    this.monitor = parts.monitor();
    this.ended = ended;
    this.laterEffects = new LaterEffects(ports, story);
    this.standing = new StandingConditions(ports);
  }

  /**
   * @param planned what is left of the plan
   */
  void begin(Step step, List<Step> planned) {
    Set<Resource> used = resourceClaims.begin(step);
    Snapshot before = ports.knowledge().snapshot();
    CallArguments known = new CallArguments(ports.knowledge().home(), before);
    Map<String, Argument> arguments = known.of(step.feature(), step.bindings());
    arguments.putAll(new NextPlace(known).of(step, planned));
    ActionDispatcher.Request order =
        new ActionDispatcher.Request(goalId, step, arguments, timeout(step));
    boolean isAskedAgain = ports.dispatcher().isOwed(goalId, step.key());
    Optional<Snapshot> lately = Optional.of(before).filter(b -> !isAskedAgain);
    perform(order, used, before, report -> run(step, lately, report));
  }

  /**
   * A step that was begun before this coordinator was there, in its former words. What its member
   * says of itself may have been said before the step or after it.
   */
  void takeUp(ActionDispatcher.Request order) {
    perform(
        order,
        resourceClaims.begin(order.step()),
        ports.knowledge().snapshot(),
        report ->
            run(
                order.step(),
                Optional.empty(),
                report.with(report.account().map(StepAccount::begunLongAgo))));
  }

  private void perform(
      ActionDispatcher.Request order,
      Set<Resource> used,
      Snapshot before,
      Function<ActionDispatcher.Report, FeatureRun> teaches) {
    Step step = order.step();
    ActionDispatcher.Handle[] performance = new ActionDispatcher.Handle[1];
    Consumer<ActionDispatcher.Report> done =
        report -> {
          ActionDispatcher.Report told =
              PossibleReasons.of(step, standing.over(step, report), ports.knowledge().home());
          reported(step, used, before, told, teaches.apply(told), performance[0]);
        };
    boolean[] isUnwanted = {order.ends()};
    Consumer<ActionDispatcher.Report> answered =
        report -> {
          if (isUnwanted[0]) {
            done.accept(report);
          } else {
            laterEffects.await(
                step, report, order.timeout(), end -> activeGoals.run(() -> done.accept(end)));
          }
        };
    AwaitedReport awaited =
        new AwaitedReport(ports, report -> activeGoals.run(() -> answered.accept(report)));
    performance[0] =
        endingBoth(step, ports.dispatcher().perform(order, awaited::arrived), isUnwanted);
    underway.begun(step, before, performance[0]);
    standing.begun(step, performance[0]);
    Duration longest =
        order
            .timeout()
            .plus(step.feature().timing().grace().orElse(Duration.ZERO))
            .plus(busTime().multipliedBy(2));
    awaited.until(longest, step.member(), performance[0]);
  }

  /** Calls off the step, also while its effect is still to come. */
  private ActionDispatcher.Handle endingBoth(
      Step step, ActionDispatcher.Handle call, boolean[] isUnwanted) {
    return new ActionDispatcher.Handle() {
      @Override
      public void cancel() {
        isUnwanted[0] = true;
        call.cancel();
        laterEffects.giveUp(step.key());
      }

      @Override
      public Optional<Duration> aliveAt() {
        return call.aliveAt();
      }
    };
  }

  /** An effect that was to come may be there, or what has to hold meanwhile may not any more. */
  void knowledgeChanged(KnowledgeBase.Change change) {
    standing.look(change);
    laterEffects.look();
  }

  /** Of its calls their answers tell; of effects that were still to come nobody does. */
  void memberLost(String member) {
    laterEffects.memberLost(member);
  }

  /**
   * Steps under way that the new plan does not want are called off, and so is what has no answer,
   * and a look at what is to be changed before it is looked at.
   */
  void callOffAllBut(List<Step> wanted) {
    Set<StepKey> keys =
        wanted.stream()
            .filter(step -> !PrematureLook.isIn(wanted, step))
            .map(Step::key)
            .collect(Collectors.toSet());
    underway.callOffAllBut(keys, story::cancelled);
    ports.dispatcher().giveUpOwed(goalId, key -> !keys.contains(key)).forEach(this::end);
  }

  /** Its member may be at it still; what it says now of what it did counts all the same. */
  private void end(ActionDispatcher.Request order) {
    Step step = order.step();
    story.ends(step);
    perform(
        order,
        resourceClaims.begin(step),
        ports.knowledge().snapshot(),
        report -> run(step, Optional.empty(), report));
    underway.isEnding(step);
  }

  /**
   * The goal is over: nothing that runs for it goes on, but what makes it so that it is reached.
   */
  void release(GoalState how) {
    underway.callOffAllBut(Set.of(), step -> {});
    established.stream()
        .filter(one -> how != GoalState.ACHIEVED || !isForTheGoalItself(one.step()))
        .forEach(one -> one.performance().cancel());
  }

  /** What was seen stays so when nobody looks any more. */
  private boolean isForTheGoalItself(Step step) {
    Effect effect = step.feature().effect();
    return !Sensing.isIn(effect) && monitor.isAbout(effect);
  }

  /** What its maker allows it, else thrice the expected time; and what the bus may take. */
  private Duration timeout(Step step) {
    return step.feature()
        .timing()
        .limit()
        .orElseGet(() -> Duration.ofMillis((long) (step.seconds() * 3_000)))
        .plus(busTime());
  }

  private Duration busTime() {
    return ports.clock().ofWallAtLeast(ON_THE_BUS);
  }

  private void reported(
      Step step,
      Set<Resource> used,
      Snapshot before,
      ActionDispatcher.Report report,
      FeatureRun run,
      ActionDispatcher.Handle performance) {
    boolean calledOff = underway.ended(step);
    resourceClaims.ended(step, used);
    exactPrices.forget(step.member());
    String factsBefore = monitor.lessons().factsUnder(step.key());
    KnowledgeBase.Change change = ports.knowledge().learn(run);
    ActionDispatcher.Report judged = judged(step, report, change, performance);
    if (life.isOver()) {
      return;
    }
    if (judged.succeeded()) {
      resourceClaims.done(step, before);
      if (step.feature().continuous()) {
        keepOrEnd(step, performance);
      }
    }
    if (isNeverEstablished(step, report)) {
      ports.dispatcher().giveUpOwed(goalId, step.key()::equals).forEach(this::end);
    }
    ended.accept(new StepEnd(step, judged, calledOff, factsBefore, before, change));
  }

  /** Its member is there, and may be at it; nothing is claimed by what is to be called off. */
  private boolean isNeverEstablished(Step step, ActionDispatcher.Report report) {
    return report.unanswered() && step.feature().continuous() && roster.isPresent(step.member());
  }

  /**
   * A result that teaches nothing is none, and neither is one that its member's own state denies;
   * what was sound in it is known all the same.
   */
  private ActionDispatcher.Report judged(
      Step step,
      ActionDispatcher.Report report,
      KnowledgeBase.Change change,
      ActionDispatcher.Handle performance) {
    if (!report.succeeded()) {
      return isNeverEstablished(step, report)
          ? failed(
              Sentences.withoutFullStop(report.problem().orElse("It has not answered"))
                  + "; what is continuous has to tell by progress ESTABLISHED that its effect is"
                  + " there.")
          : report;
    }
    if (!change.denials().isEmpty()) {
      return failed(story.deniedByItself(step, change));
    }
    Experience experience = activeGoals.experience();
    Optional<String> objection = objection(step, report);
    if (objection.isEmpty()) {
      experience.taught(step.member(), step.feature().name());
      return report;
    }
    String problem = step.member() + " reports a result that teaches nothing: " + objection.get();
    experience.taughtNothing(step.member(), step.feature().name(), problem);
    if (step.feature().continuous()) {
      performance.cancel();
    }
    return failed(problem + ".");
  }

  private static ActionDispatcher.Report failed(String problem) {
    return new ActionDispatcher.Report(false, Map.of(), Optional.of(problem), List.of());
  }

  private Optional<String> objection(Step step, ActionDispatcher.Report report) {
    return ResultCheck.objection(step.feature(), report.outputs())
        .or(() -> EmptyResult.of(step, ports.knowledge()));
  }

  /**
   * Sight is kept until the goal ends, and so is what is so only as long as it goes on; one reading
   * of a number is enough while it is valid.
   */
  private void keepOrEnd(Step step, ActionDispatcher.Handle performance) {
    Effect effect = step.feature().effect();
    if (Sensing.isOfAtoms(effect) || !Sensing.isIn(effect)) {
      established.add(new Established(step, performance));
    } else {
      performance.cancel();
    }
  }

  private static FeatureRun run(
      Step step, Optional<Snapshot> before, ActionDispatcher.Report report) {
    Map<String, Term> bindings = step.values();
    return new FeatureRun(
        step.member(),
        Confirmation.described(step.feature()),
        bindings,
        report.succeeded(),
        report.outputs(),
        report.refs(),
        before,
        report.begun(),
        report.account());
  }
}
