package org.maestro.coordination.achievement;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import org.maestro.coordination.allocation.ExactPrices;
import org.maestro.coordination.allocation.PlanPurpose;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.CallArguments;
import org.maestro.coordination.api.CallForPrices;
import org.maestro.coordination.api.ContractNet;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Proposal;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Roster;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.contention.ActiveGoals;
import org.maestro.coordination.lessons.VainDeeds;
import org.maestro.coordination.recovery.FormerCalls;
import org.maestro.coordination.story.Decisions;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.Step;
import org.maestro.sl.Change;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;

/**
 * One call of one member, as a step of a script wants it: with the same leases, words and waits as
 * the steps of plans, and made once. The coordinator's thread only.
 */
public final class CallGoal extends PlannedPursuit {
  private final FeatureCall call;
  private final LastReport reports;

  public CallGoal(
      String id,
      FeatureCall call,
      GoalRequest request,
      Ports ports,
      Roster roster,
      ActiveGoals activeGoals,
      ExactPrices exactPrices,
      Consumer<GoalOutcome> ended) {
    this(
        id,
        call,
        request,
        ports,
        new LastReport(ports.dispatcher()),
        roster,
        activeGoals,
        exactPrices,
        ended);
  }

  private CallGoal(
      String id,
      FeatureCall call,
      GoalRequest request,
      Ports ports,
      LastReport reports,
      Roster roster,
      ActiveGoals activeGoals,
      ExactPrices exactPrices,
      Consumer<GoalOutcome> ended) {
    super(
        id,
        request,
        ports.with(reports),
        roster,
        activeGoals,
        exactPrices,
        new VainDeeds(),
        PlanPurpose.REACH,
        ended);
    this.call = call;
    this.reports = reports;
  }

  @Override
  public void start() {
    if (life.isOver()) {
      return;
    }
    String member = call.member();
    if (StepOfCall.feature(call, parts.ports().knowledge().home()).isEmpty()) {
      giveUp(List.of("%s offers no %s.".formatted(member, call.feature())));
    } else if (!parts.roster().isPresent(member)) {
      giveUp(
          List.of(
              "%s is needed and not there (%s)."
                  .formatted(member, parts.roster().absence(member))));
    } else {
      life.become(life.plans() == 0 ? GoalPhase.PLANNING : GoalPhase.REPLANNING, "");
      parts
          .ports()
          .contractNet()
          .callForPrices(
              new CallForPrices(
                  life.id(), life.request().goal(), Map.of(member, List.of(call.feature()))),
              round -> parts.activeGoals().run(() -> answered(round)));
    }
  }

  private void answered(ContractNet.Round round) {
    if (life.isOver()) {
      round.reject();
      return;
    }
    life.become(GoalPhase.DECIDING);
    Optional<Proposal> proposal =
        round.bids().stream().filter(bid -> bid.member().equals(call.member())).findFirst();
    Optional<String> refusal =
        proposal.isEmpty() ? Optional.of("it did not answer") : proposal.get().refusal();
    if (refusal.isPresent()) {
      round.reject();
      giveUp(List.of("%s refuses: %s".formatted(call.member(), refusal.get())));
      return;
    }
    StepOfCall chosen =
        StepOfCall.of(
            call,
            parts.ports().knowledge().home(),
            parts.ports().knowledge().snapshot(),
            Optional.ofNullable(proposal.get().prices().get(call.feature()))
                .orElseGet(
                    () ->
                        StepOfCall.feature(call, parts.ports().knowledge().home())
                            .orElseThrow()
                            .cost()));
    if (chosen.step().isEmpty()) {
      round.reject();
      giveUp(List.of(chosen.problem()));
    } else if (chosen.step().get().exactPrice()) {
      adopt(chosen.step().get(), round);
    } else {
      askForPrice(chosen.step().get(), round);
    }
  }

  private void askForPrice(Step step, ContractNet.Round round) {
    Ports ports = parts.ports();
    ports
        .contractNet()
        .exactPrices(
            life.id(),
            step.member(),
            step.feature().name(),
            List.of(
                new CallArguments(ports.knowledge().home(), ports.knowledge().snapshot())
                    .of(step.feature(), step.bindings())),
            quotes -> parts.activeGoals().run(() -> adopt(StepOfCall.at(step, quotes), round)));
  }

  private void adopt(Step step, ContractNet.Round round) {
    if (life.isOver()) {
      round.reject();
    } else {
      life.countPlan(false);
      following.adopt(new Plan(List.of(step), step.cost(), Map.of()), round);
    }
  }

  @Override
  public void takeUp(Recovery.UnfinishedGoal goal, FormerCalls former) {
    if (life.isOver()) {
      goal.calls().forEach(begun -> former.giveUp(begun, "its goal is over"));
      return;
    }
    for (Recovery.UnfinishedCall begun : goal.calls()) {
      Optional<String> obstacle = former.obstacle(begun);
      parts.story().takenUp(begun, obstacle);
      if (obstacle.isPresent()) {
        former.giveUp(begun, obstacle.get());
        giveUp(
            List.of(
                "It was under way, and nobody knows what became of it: %s."
                    .formatted(obstacle.get())));
        return;
      }
      following.takeUp(former.order(begun));
    }
    if (!parts.underway().isEmpty()) {
      return;
    }
    if (goal.lastEnd().isEmpty()) {
      start();
    } else if (goal.lastEnd().get().problem().isEmpty()) {
      end(GoalState.ACHIEVED, List.of());
    } else {
      giveUp(List.of(Sentences.said(call.member(), goal.lastEnd().get().problem().get())));
    }
  }

  @Override
  public void cancel(String who) {
    end(GoalState.CANCELLED, List.of("Cancelled by " + who + "."));
  }

  @Override
  public void deadlinePassed() {
    end(GoalState.FAILED, List.of("Its deadline has passed" + life.standingInWords() + "."));
  }

  /** It was called once, or cannot be: there is no other way. */
  @Override
  public void makePlan(Optional<String> why) {
    if (!parts.underway().isEmpty()) {
      return;
    }
    Optional<Boolean> succeeded = reports.last().map(report -> report.succeeded());
    if (succeeded.isPresent()) {
      reported();
    } else {
      giveUp(List.of(why.orElse("It cannot be called now.")));
    }
  }

  private void reported() {
    if (reports.last().orElseThrow().succeeded()) {
      end(GoalState.ACHIEVED, List.of());
    } else {
      giveUp(
          List.of(
              Sentences.said(
                  call.member(),
                  reports.last().orElseThrow().problem().orElse("no reason given"))));
    }
  }

  @Override
  public void makePlanAgain(String why) {
    makePlan(Optional.of(why));
  }

  @Override
  public void noPlan(PlanningRound.Ended round) {
    giveUp(List.of("It cannot be called now."));
  }

  @Override
  public void noPlanToSeeIt() {
    end(GoalState.ACHIEVED, List.of());
  }

  /** Nothing is to be so afterwards: it is over when the call is. */
  @Override
  public void settle(Map<String, Term> binding) {
    Snapshot now = parts.ports().knowledge().snapshot();
    if (reports.last().isPresent()) {
      reported();
    } else if (parts.plan().remaining().stream()
        .allMatch(step -> StepOfCall.isPossible(step, now))) {
      following.advance();
    } else {
      chooseAgain();
    }
  }

  /** What was left open may have to stand for something else now. */
  private void chooseAgain() {
    parts.story().planning(life.plans() + 1, Optional.of("things have changed while it waited"));
    start();
  }

  @Override
  public void giveUp(List<String> reasons) {
    end(GoalState.FAILED, reasons);
  }

  @Override
  public Decisions decisions() {
    return new Decisions();
  }

  @Override
  public Optional<Formula> countsOn(List<Change> changes, Snapshot now, String other) {
    return life.isOver() || life.state() == GoalState.SUSPENDED
        ? Optional.empty()
        : parts.resourceClaims().spoiledBy(changes, now, false, false);
  }
}
