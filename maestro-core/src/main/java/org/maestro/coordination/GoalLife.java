package org.maestro.coordination;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.maestro.rats.time.Clock;
import org.maestro.sl.SlPrinter;
import org.maestro.sl.Term;

/** Where one goal stands and why, what it took so far, and how it ended. */
final class GoalLife {
  private final String id;
  private final GoalRequest request;
  private final Clock clock;
  private final GoalStory story;
  private final Consumer<GoalOutcome> ended;
  private final Duration submittedAt;
  private final long submittedNanos = System.nanoTime();

  private GoalState state = GoalState.SUBMITTED;
  private String detail = "";
  private int plans;
  private int confirmingPlans;
  private int calls;
  private double decisionMillis;

  GoalLife(
      String id, GoalRequest request, Clock clock, GoalStory story, Consumer<GoalOutcome> ended) {
    this.id = id;
    this.request = request;
    this.clock = clock;
    this.story = story;
    this.ended = ended;
    this.submittedAt = clock.now();
  }

  String id() {
    return id;
  }

  GoalRequest request() {
    return request;
  }

  GoalState state() {
    return state;
  }

  boolean isOver() {
    return state.isFinal();
  }

  GoalStatus status() {
    return new GoalStatus(id, SlPrinter.print(request.goal()), request.requester(), state, detail);
  }

  /** The only way to another state, except to an end. */
  void become(GoalState next, String why) {
    state = next;
    detail = why;
  }

  int plans() {
    return plans;
  }

  void countPlan(boolean confirming) {
    plans++;
    if (confirming) {
      confirmingPlans++;
    }
  }

  void countCall() {
    calls++;
    if (calls == 1) {
      decisionMillis = (System.nanoTime() - submittedNanos) / 1e6;
    }
  }

  void end(GoalState how, boolean confirmed, Map<String, Term> binding, List<String> reasons) {
    become(how, String.join(" ", reasons));
    GoalOutcome outcome =
        new GoalOutcome(
            id,
            SlPrinter.print(request.goal()),
            how,
            confirmed,
            binding,
            reasons,
            calls,
            Math.max(0, plans - confirmingPlans - 1),
            submittedAt,
            clock.now(),
            decisionMillis);
    story.ended(outcome);
    ended.accept(outcome);
  }
}
