package org.maestro.coordination.story;

import java.time.Duration;
import java.util.EnumSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.Consumer;
import org.maestro.coordination.api.GoalEffort;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalRequest;
import org.maestro.coordination.api.GoalState;
import org.maestro.coordination.api.GoalStatus;
import org.maestro.coordination.api.Journal;
import org.maestro.coordination.api.JournalEntry;
import org.maestro.coordination.api.Ports;
import org.maestro.coordination.api.Recovery;
import org.maestro.coordination.api.SearchReport;
import org.maestro.coordination.api.WaitsFor;
import org.maestro.rats.time.Clock;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** The state of one goal and the reason for it, what the goal took so far, and how it ended. */
public final class GoalLife {
  private final String id;
  private final GoalRequest request;
  private final Clock clock;
  private final Journal journal;
  private final GoalStory story;
  private final Consumer<GoalOutcome> ended;
  private Duration submittedAt;
  private final long submittedNanos = System.nanoTime();

  private GoalPhase phase = GoalPhase.SUBMITTED;
  private final Set<GoalPhase> past = EnumSet.noneOf(GoalPhase.class);
  private GoalState state = GoalState.SUBMITTED;
  private String detail = "";
  private GoalEffort effort = GoalEffort.NONE;
  private double decisionMillis;

  public GoalLife(
      String id, GoalRequest request, Ports ports, GoalStory story, Consumer<GoalOutcome> ended) {
    this.id = id;
    this.request = request;
    this.clock = ports.clock();
    this.journal = ports.journal();
    this.story = story;
    this.ended = ended;
    this.submittedAt = ports.clock().now();
  }

  public String id() {
    return id;
  }

  public GoalRequest request() {
    return request;
  }

  /** By the clock; before its start for a goal that was taken up. */
  public Duration submittedAt() {
    return submittedAt;
  }

  public GoalState state() {
    return state;
  }

  public String detail() {
    return detail;
  }

  public GoalPhase phase() {
    return phase;
  }

  /** Whether it was ever in that phase, since this coordinator is there. */
  public boolean wasIn(GoalPhase phase) {
    return past.contains(phase);
  }

  /** Whether nothing is begun for it any more. */
  public boolean isOver() {
    return phase.isOver();
  }

  public GoalStatus status(List<WaitsFor> waits) {
    return new GoalStatus(
            id,
            SlPrinter.print(request.goal()),
            request.requester(),
            state,
            detail,
            request.priority(),
            request.deadline().map(deadline -> deadline.minus(clock.now())),
            clock.now().minus(submittedAt),
            waits)
        .stakes(request.stakes());
  }

  /** What it is at, as the end of a sentence. */
  public String standingInWords() {
    String where = state.name().toLowerCase(Locale.ROOT);
    return detail.isEmpty() ? " while " + where : " while " + where + " (" + detail + ")";
  }

  /** It began before this coordinator was there. */
  public void takeUp(Recovery.UnfinishedGoal former) {
    submittedAt = former.submittedAt();
    effort = former.effort();
    state = former.state();
    detail = former.detail();
  }

  /** The only way to another phase; what is seen from outside is written down. */
  public void become(GoalPhase next, String why) {
    enter(next);
    next.shown()
        .ifPresent(
            shown -> {
              state = shown;
              detail = why;
              if (!shown.isFinal()) {
                journal.write(new JournalEntry.Became(id, shown, why, effort));
              }
            });
  }

  /** The same, without a word of it where just that is seen from outside already. */
  public void becomeIfNew(GoalPhase next, String why) {
    if (next.shown().equals(Optional.of(state)) && detail.equals(why)) {
      enter(next);
    } else {
      become(next, why);
    }
  }

  /** Enters another phase without a word of it: what is seen from outside stays as it is. */
  public void become(GoalPhase next) {
    enter(next);
  }

  private void enter(GoalPhase next) {
    assert phase.next().contains(next) : id + " cannot go from " + phase + " to " + next;
    phase = next;
    past.add(next);
  }

  public int plans() {
    return effort.plans();
  }

  /** How many steps were begun for it. */
  public int calls() {
    return effort.calls();
  }

  public int confirmingPlans() {
    return effort.confirmingPlans();
  }

  public void countPlan(boolean confirming) {
    effort = effort.planned(confirming);
  }

  public void countCall() {
    effort = effort.called();
    if (effort.calls() == 1) {
      decisionMillis = (System.nanoTime() - submittedNanos) / 1e6;
    }
  }

  /** What was done for a part of it was done for it; that is written down. */
  public void add(GoalOutcome part) {
    effort = effort.with(part);
    journal.write(new JournalEntry.Became(id, state, detail, effort));
  }

  public void end(
      GoalState how, boolean confirmed, Map<String, Term> binding, List<String> reasons) {
    end(how, confirmed, binding, reasons, List.of());
  }

  public void end(
      GoalState how,
      boolean confirmed,
      Map<String, Term> binding,
      List<String> reasons,
      List<SearchReport> searches) {
    become(GoalPhase.of(how), String.join(" ", reasons));
    GoalOutcome outcome =
        new GoalOutcome(
            id,
            SlPrinter.print(request.goal()),
            how,
            confirmed,
            binding,
            reasons,
            effort.calls(),
            effort.replans(),
            submittedAt,
            clock.now(),
            decisionMillis,
            searches);
    story.ended(outcome);
    journal.write(new JournalEntry.Over(outcome));
    ended.accept(outcome);
  }
}
