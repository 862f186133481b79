package org.maestro.coordination.achievement;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Stream;
import org.maestro.coordination.api.GoalId;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.Sentences;
import org.maestro.coordination.api.Story;
import org.maestro.coordination.api.StoryEntry;
import org.maestro.coordination.story.GoalPhase;
import org.maestro.knowledge.api.Snapshot;
import org.maestro.planning.api.Plan;
import org.maestro.planning.api.PlannedSearch;
import org.maestro.sl.Formula;
import org.maestro.sl.Term;
import org.maestro.sl.Truth;

/**
 * The looks that a goal has made beside its plan, where what it seeks may be in many places. One
 * look after the other costs least; but as many at once as were in vain before cost at most twice
 * as much, however long it is sought, and take far less time. Where time has a price they begin
 * with the plan. Once they are many no plan is made for each look in vain: what comes after the
 * search is planned when it has found something. The coordinator's thread only.
 */
final class LooksBeside {
  /** Looks at once: each is planned, and has calls under way. */
  private static final int MOST = 16;

  /** So many do without another one that the plan makes. */
  private static final int MANY = 4;

  /** Times as much as the first one, with all that has to be done for it. */
  private static final double MOST_COST = 4;

  private final PursuitParts parts;
  private final Runnable over;
  private final Map<Formula.Atom, LookGoal> underway = new LinkedHashMap<>();
  private final Set<Formula.Atom> tried = new HashSet<>();
  private List<PlannedSearch> searches = List.of();
  private int number;
  private int inVain;
  private boolean isOver;

  /**
   * @param parts of the goal that seeks
   * @param over run when a look is over
   */
  LooksBeside(PursuitParts parts, Runnable over) {
    this.parts = parts;
    this.over = over;
  }

  /** Looks from before a restart keep their numbers: what ran for them may not have ended. */
  void takeUp(Recovery.UnfinishedGoal goal) {
    Stream.concat(
            goal.parts().stream().map(Recovery.UnfinishedGoal::id),
            goal.endedParts().stream().map(part -> part.outcome().id()))
        .filter(part -> GoalId.isBeside(part, parts.id()))
        .forEach(part -> number = Math.max(number, GoalId.lastNumber(part)));
  }

  /** A plan was taken, and what it seeks is sought elsewhere as well. */
  void adopted(Plan plan) {
    searches = plan.searches();
    cancelUnwanted();
    beginMore();
  }

  boolean isAny() {
    return !underway.isEmpty();
  }

  /** Whether nothing is to be planned while they go on. */
  boolean goOnAlone() {
    return underway.size() >= MANY && !haveFound();
  }

  /** The goal has no plan now, and they go on without it. */
  void planDropped() {
    beginMore();
  }

  /** Whether it is known of all that is sought where it is. */
  boolean haveFound() {
    Snapshot now = parts.ports().knowledge().snapshot();
    return searches.stream()
        .allMatch(search -> now.value(search.predicate(), search.arguments()).isPresent());
  }

  /** The goal is over. */
  void end() {
    isOver = true;
    searches = List.of();
    cancelUnwanted();
  }

  /** Looks for what the plan does not seek any more. */
  private void cancelUnwanted() {
    List<LookGoal> unwanted = new ArrayList<>();
    underway.forEach(
        (sought, look) -> {
          if (searches.stream().noneMatch(search -> isIn(search, sought))) {
            unwanted.add(look);
          }
        });
    unwanted.forEach(look -> look.cancel(parts.id()));
  }

  private static boolean isIn(PlannedSearch search, Formula.Atom sought) {
    return sought.equals(atom(search, sought.arguments().get(sought.arguments().size() - 1)));
  }

  private void beginMore() {
    GoalPhase phase = parts.life().phase();
    // The plan that is being made may look there itself.
    if (isOver || phase.isOver() || phase.isResting() || phase.isPlanning()) {
      return;
    }
    Snapshot now = parts.ports().knowledge().snapshot();
    for (PlannedSearch search : searches) {
      List<Formula.Atom> open =
          search.places().stream()
              .skip(parts.plan().exists() ? 1 : 0)
              .map(place -> atom(search, place.value()))
              .filter(sought -> now.truth(sought) == Truth.UNKNOWN)
              .toList();
      int atOnce = atOnce(open.size());
      for (Formula.Atom sought : open) {
        if (underway.size() < atOnce && tried.add(sought)) {
          begin(sought, MOST_COST * search.places().get(0).lookCost());
        }
      }
    }
  }

  private int atOnce(int open) {
    if (timeHasAPrice()) {
      return MOST;
    }
    int before = parts.monitor().lessons().placesLookedAt() + inVain;
    return before + open > PlannedSearch.MANY_PLACES ? Math.min(before, MOST) : 0;
  }

  /** Whether it is more urgent the longer it takes. */
  private boolean timeHasAPrice() {
    GoalRequest request = parts.life().request();
    return request
        .stakes()
        .filter(stakes -> stakes.allowed().isPresent() || request.deadline().isPresent())
        .isPresent();
  }

  private static Formula.Atom atom(PlannedSearch search, Term place) {
    List<Term> arguments = new ArrayList<>(search.arguments());
    arguments.add(place);
    return new Formula.Atom(search.predicate(), arguments);
  }

  private void begin(Formula.Atom sought, double mostCost) {
    String id = GoalId.beside(parts.id(), ++number);
    GoalRequest whole = parts.life().request();
    GoalRequest request =
        new GoalRequest(sought, whole.requester(), whole.priority(), Optional.empty());
    Ports ports = parts.ports().patient().with(told(id));
    LookGoal look =
        new LookGoal(
            id,
            sought,
            mostCost,
            request,
            ports,
            parts,
            outcome -> parts.activeGoals().run(() -> ended(sought, outcome)));
    underway.put(sought, look);
    parts.monitor().isSoughtBeside(underway.keySet());
    parts.activeGoals().enter(look, parts.activeGoals().leases().ownStanding(parts.id()));
    tell(
        StoryEntry.Kind.STEP,
        id,
        "Looks meanwhile whether %s."
            .formatted(new Sentences(ports.knowledge().home().vocabulary()).fact(sought)));
    ports
        .journal()
        .accept(
            new JournalEntry.Submitted(id, request),
            () -> parts.activeGoals().run(look::start),
            refused -> parts.activeGoals().run(() -> look.cancel("want of room: " + refused)));
  }

  private void ended(Formula.Atom sought, GoalOutcome outcome) {
    underway.remove(sought);
    if (outcome.state() == GoalState.FAILED) {
      tell(StoryEntry.Kind.FAILED, outcome.id(), String.join(" ", outcome.reasons()));
    }
    parts.monitor().isSoughtBeside(underway.keySet());
    if (parts.ports().knowledge().snapshot().truth(sought) == Truth.FALSE) {
      inVain++;
    }
    beginMore();
    over.run();
  }

  /** What a look tells is part of the story of its goal. */
  private Story told(String id) {
    return entry -> {
      switch (entry.kind()) {
        case GOAL, KNOWN, BIDS, END -> {
          // Its steps tell what it comes to; and what is known is the goal's own.
        }
        default -> tell(entry.kind(), id, entry.text());
      }
    };
  }

  private void tell(StoryEntry.Kind kind, String id, String text) {
    parts
        .ports()
        .story()
        .tell(
            new StoryEntry(
                parts.id(),
                parts.ports().clock().now(),
                kind,
                "[%s] %s".formatted(id.substring(parts.id().length() + 1), text)));
  }
}
