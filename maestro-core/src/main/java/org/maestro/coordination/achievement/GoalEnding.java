package org.maestro.coordination.achievement;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.maestro.coordination.allocation.PlanningRound;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.Resource;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.coordination.contention.ActiveGoal;
import org.maestro.coordination.facts.Confirmation;
import org.maestro.coordination.story.GoalLife;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.coordination.story.GoalStory;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlanningResult;
import org.maestro.sl.Term;

/**
 * The end of one goal: reached and seen, reached as far as is known, or given up with the reasons.
 * The coordinator's thread only.
 */
final class GoalEnding {
  /** A way that is blocked now is no proof; nobody knows for how long. */
  static final String NOT_PROVEN =
      "It is given up, and not proven to be impossible: what was refused or failed now may be"
          + " possible later.";

  /** How far things are from each other is in no effect. */
  private static final String NOT_DESCRIBED =
      "It is given up, and not proven to be impossible: who moves things may bring it about.";

  private final PursuitParts parts;
  private final GoalMonitor monitor;
  private final GoalLife life;
  private final GoalStory story;
  private final LastTry lastTry;
  private final AwaitedMembers awaited;
  private final Consumer<GoalState> release;
  private final GoalTransitions course;
  private List<String> whyNot = List.of();
  private Optional<PlanningRound.Ended> hopeless = Optional.empty();

  /**
   * @param release of what runs for the goal, by how it ends
   */
  GoalEnding(PursuitParts parts, Consumer<GoalState> release, GoalTransitions course) {
    this.parts = parts;
    this.monitor = parts.monitor();
    this.life = parts.life();
    this.story = parts.story();
    this.lastTry = new LastTry(parts.ports(), parts.activeGoals(), monitor, parts.exactPrices());
    this.awaited =
        new AwaitedMembers(parts.ports(), parts.roster(), parts.activeGoals(), monitor.goalId());
    this.release = release;
    this.course = course;
  }

  void end(GoalState how, List<String> reasons) {
    end(how, false, Map.of(), reasons);
  }

  private void end(
      GoalState how, boolean confirmed, Map<String, Term> binding, List<String> reasons) {
    awaited.forget();
    life.become(GoalPhase.ENDING);
    if (how == GoalState.ACHIEVED) {
      monitor.lessons().reached();
    }
    release.accept(how);
    life.end(how, confirmed, binding, reasons);
    parts.activeGoals().leave(life.id());
  }

  void settle(Map<String, Term> binding) {
    Optional<Confirmation> needed = monitor.toBeSeen(binding);
    if (needed.isEmpty()) {
      story.confirmed(life.request().goal(), binding);
      end(GoalState.ACHIEVED, true, binding, List.of());
    } else if (!monitor.isConfirming()) {
      monitor.confirm(needed);
      parts.plan().drop();
      story.confirming(needed.get());
      course.makePlan(Optional.empty());
    } else if (parts.underway().isEmpty() && parts.plan().remaining().isEmpty()) {
      if (needed.get().isOnlyDisputed() || !needed.get().denials().isEmpty()) {
        listenOrAsk(needed.get(), binding);
        return;
      }
      monitor.confirm(needed);
      course.makePlan(Optional.of("it was not seen"));
    } else if (parts.underway().isEmpty()
        && monitor.blocked(parts.plan().remaining()).isPresent()) {
      course.makePlan(Optional.of("it could not be seen so"));
    } else {
      course.advance();
    }
  }

  void noPlan(PlanningRound.Ended round) {
    awaited.forget();
    parts.plan().drop();
    parts.resourceClaims().letGo();
    if (!parts.underway().isEmpty()) {
      life.become(GoalPhase.WAITING_FOR_STEPS, "what is under way has to end first");
    } else if (!parts.roster().doubts().isEmpty()) {
      String doubts = String.join("; ", parts.roster().doubts().values());
      life.become(GoalPhase.WAITING_FOR_CERTAINTY, doubts);
      story.awaitsCertainty(doubts);
    } else if (monitor.isConfirming()) {
      noPlanToSeeIt();
    } else if (round.result() instanceof PlanningResult.Impossible impossible
        && parts.ports().knowledge().doubt(conditions(impossible))) {
      course.makePlan(
          Optional.of("by what was learnt from measurements nobody can make it so; it is doubted"));
    } else if (!monitor.isFindingOut() && lastTry.isLeft(round)) {
      life.become(
          GoalPhase.WAITING_FOR_ANOTHER_TRY, "what failed or was not priced is tried once more");
      story.triesOnceMore(lastTry.pause(), monitor.lessons().asLeftOpen(round.result()));
      lastTry.afterPause(this::tryOnceMore);
    } else if (monitor.isFindingOut()) {
      awaitOrGiveUp();
    } else {
      whyNot = reasons(round);
      hopeless = Optional.of(round);
      if (monitor.canFindOut()) {
        monitor.findOut();
        course.makePlan(Optional.of("nobody can make it so, but it may be so already"));
      } else {
        awaitOrGiveUp();
      }
    }
  }

  private static List<String> conditions(PlanningResult.Impossible impossible) {
    return impossible.explanation().obstacles().stream()
        .map(PlanningResult.Obstacle::condition)
        .toList();
  }

  private void awaitOrGiveUp() {
    List<ActiveGoal> keepers = monitor.lessons().keepersThatMayTurn();
    if (!keepers.isEmpty()) {
      awaitTurnOf(keepers);
      return;
    }
    PlanningResult result = hopeless.orElseThrow().result();
    Set<String> missed = awaited.missed(result);
    if (missed.isEmpty()) {
      giveUp(whyNot);
      return;
    }
    Duration atMost = awaited.await(missed, result, () -> goOn("nobody has come back"));
    String members =
        missed.stream()
            .map(
                member ->
                    (parts.roster().isLost(member) ? "for %s to come back (%s)" : "for %s (%s)")
                        .formatted(member, parts.roster().absence(member)))
            .collect(Collectors.joining(", "));
    life.become(GoalPhase.WAITING_FOR_MEMBERS, members);
    story.awaits(members, atMost);
  }

  /** What they are worth changes: there is a plan as soon as this goal goes before one of them. */
  private void awaitTurnOf(List<ActiveGoal> keepers) {
    List<WaitsFor> edges =
        keepers.stream()
            .map(
                keeper ->
                    new WaitsFor(
                        life.id(), Resource.fact(keeper.status().goal() + " is kept"), keeper.id()))
            .toList();
    parts.activeGoals().leases().waitFor(life.id(), Set.of(), edges);
    life.become(
        GoalPhase.WAITING_FOR_RANK,
        keepers.stream()
            .map(
                keeper ->
                    keeper.id()
                        + " goes first"
                        + parts.activeGoals().whyFirst(keeper.id(), life.id()))
            .collect(Collectors.joining(", ")));
    story.waits(edges);
  }

  /** What it, or one that it waits for, is worth may be another. */
  void advance() {
    if (life.phase() != GoalPhase.WAITING_FOR_RANK) {
      return;
    }
    List<ActiveGoal> keepers = monitor.lessons().keepersThatMayTurn();
    List<ActiveGoal> outranked =
        keepers.stream()
            .filter(keeper -> !parts.activeGoals().goesOnBefore(keeper.id(), life.id()))
            .toList();
    if (!outranked.isEmpty()) {
      outranked.forEach(monitor.lessons()::leaveAloneNoMore);
      course.makePlan(Optional.of("it goes before " + outranked.get(0).id() + " now"));
    } else if (keepers.isEmpty()) {
      course.makePlan(Optional.of("nothing is kept any more that it would end"));
    }
  }

  private void goOn(String why) {
    if (awaited.isAny() && !life.isOver()) {
      awaited.forget();
      course.makePlan(Optional.of(why));
    }
  }

  /** It may be one that is waited for, or one that can stand in for it. */
  void memberPresent(String member) {
    if (awaited.isAny() && monitor.isCandidate(member)) {
      goOn(member + " is there");
    }
  }

  void knowledgeChanged() {
    if (awaited.isAny() && (awaited.isHelped() || monitor.holds().isPresent())) {
      goOn("things have changed while it waited");
    }
  }

  /** Nobody is given up for want of one who may be there; now one of them is, or is lost. */
  void doubtOver(String member) {
    if (life.phase() == GoalPhase.WAITING_FOR_CERTAINTY) {
      course.makePlan(
          Optional.of(
              parts.roster().isPresent(member)
                  ? member + " is there again"
                  : member + " is lost (" + parts.roster().absence(member) + ")"));
    }
  }

  private List<String> reasons(PlanningRound.Ended round) {
    List<String> reasons = new ArrayList<>(monitor.lessons().reasonsOfLeavingAlone());
    reasons.addAll(story.reasons(monitor.lessons().asLeftOpen(round.result())));
    reasons.addAll(monitor.lessons().reasonsOfVainDeeds());
    reasons.addAll(awaited.perhapsWithTheLost(round.result()));
    round.notCountedOn().ifPresent(reasons::add);
    monitor.openChoices().forEach(open -> reasons.add(open.sentence()));
    if (monitor.restsOnRefusals(round.result())) {
      reasons.add(NOT_PROVEN);
    } else if (monitor.restsOnPlaces()) {
      reasons.add(NOT_DESCRIBED);
    }
    return reasons;
  }

  private void tryOnceMore() {
    if (!life.isOver()) {
      monitor.trustEarlierSteps();
      course.makePlan(Optional.of("what failed or was not priced may be possible now"));
    }
  }

  void noPlanToSeeIt() {
    Optional<Plan> reached = monitor.holds();
    if (reached.isPresent()) {
      Map<String, Term> binding = reached.get().goalBinding();
      monitor
          .toBeSeen(binding)
          .ifPresentOrElse(needed -> listenOrAsk(needed, binding), () -> settle(binding));
    } else {
      monitor.confirm(Optional.empty());
      course.makePlan(Optional.of("it cannot be seen any more that the goal is reached"));
    }
  }

  /** Who tells of it of its own accord has some time to do so. */
  private void listenOrAsk(Confirmation needed, Map<String, Term> binding) {
    if (life.wasIn(GoalPhase.LISTENING) || needed.tellers().isEmpty()) {
      askBeforeTheEnd(needed, binding);
      return;
    }
    String tellers = String.join(", ", needed.tellers());
    life.become(GoalPhase.LISTENING, "for what " + tellers + " may tell");
    story.listens(tellers, LastTry.PAUSE);
    Speakers.ask(needed.speakers(), parts.ports().dispatcher(), () -> {});
    lastTry.afterPause(
        () -> {
          if (!life.isOver()) {
            course.makePlan(Optional.of(tellers + " had time to tell"));
          }
        });
  }

  /** All who have told of it are asked once more: what they said may be older than the deed. */
  private void askBeforeTheEnd(Confirmation needed, Map<String, Term> binding) {
    if (needed.speakers().isEmpty()) {
      conclude(needed, binding);
      return;
    }
    life.become(GoalPhase.ASKING, "for what " + String.join(", ", needed.speakers()) + " say");
    Speakers.ask(
        needed.speakers(),
        parts.ports().dispatcher(),
        () -> parts.activeGoals().run(() -> heard(needed)));
  }

  /** What those say who were asked is known. */
  private void heard(Confirmation asked) {
    if (life.phase() != GoalPhase.ASKING) {
      return;
    }
    Optional<Plan> reached = monitor.holds();
    if (reached.isEmpty()) {
      monitor.confirm(Optional.empty());
      course.makePlan(
          Optional.of(
              "%s asked once more, and the goal is not reached"
                  .formatted(Sentences.were(asked.speakers()))));
      return;
    }
    Map<String, Term> binding = reached.get().goalBinding();
    monitor
        .toBeSeen(binding)
        .ifPresentOrElse(needed -> conclude(needed, binding), () -> settle(binding));
  }

  /** Whoever did it is believed where nobody can look, and not against who has looked. */
  private void conclude(Confirmation needed, Map<String, Term> binding) {
    if (needed.denials().isEmpty() && needed.missed().isEmpty()) {
      end(GoalState.ACHIEVED, false, binding, List.of(story.unconfirmed(needed)));
    } else {
      giveUp(List.of(story.denied(needed), NOT_PROVEN));
    }
  }

  /** Ends it, with what was looked at in vain and what could not be looked at. */
  void giveUp(List<String> reasons) {
    SearchReview review = monitor.searchReview(parts.roster());
    parts
        .ports()
        .thinking()
        .patient()
        .think(
            () -> review.reports(life.request().goal()),
            reports -> parts.activeGoals().run(() -> gaveUp(reasons, reports)));
  }

  private void gaveUp(List<String> reasons, List<SearchReport> reports) {
    if (!life.isOver()) {
      List<String> all = new ArrayList<>(reasons);
      reports.forEach(report -> all.addAll(story.searched(report)));
      life.become(GoalPhase.ENDING);
      release.accept(GoalState.FAILED);
      life.end(GoalState.FAILED, false, Map.of(), all, reports);
      parts.activeGoals().leave(life.id());
    }
  }
}
