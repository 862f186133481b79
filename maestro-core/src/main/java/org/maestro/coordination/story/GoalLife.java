package org.maestro.coordination.story;

import java.time.Duration;
import java.util.List;
import java.util.Locale;
import java.util.Map;
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

/** Where one goal stands and why, what it took so far, and how it ended. */
public final class GoalLife {
  private final String id;
  private final GoalRequest request;
  private final Clock clock;
  private final Journal journal;
  private final GoalStory story;
  private final Consumer<GoalOutcome> ended;
  private Duration submittedAt;
  private final long submittedNanos = System.nanoTime();

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

  public GoalState state() {
    return state;
  }

  public String detail() {
    return detail;
  }

  public boolean isOver() {
    return state.isFinal();
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
        waits);
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

  /** The only way to another state, except to an end. */
  public void become(GoalState next, String why) {
    state = next;
    detail = why;
    if (!next.isFinal()) {
      journal.write(new JournalEntry.Became(id, next, why, effort));
    }
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
    become(how, String.join(" ", reasons));
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
