package org.maestro.agents.content;

import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.maestro.coordination.api.GoalOutcome;
import org.maestro.coordination.api.GoalState;
import org.maestro.sl.Content;
import org.maestro.sl.Formula;
import org.maestro.sl.Substitution;
import org.maestro.sl.Term;

/**
 * The report of a goal's end, as its requester is told: written by who pursued it, read by who
 * stated it.
 *
 * @param id empty when the CCA refused the goal
 * @param confirmed somebody has seen it who did not do it; false when only its doer says so
 * @param binding values of the goal's free variables
 * @param reasons why it failed or was refused, in sentences; empty when reached
 * @param calls feature calls started
 * @param replans plans made after the first
 * @param duration simulated time from arrival to end
 * @param decisionMillis wall time from arrival to the first call; 0 when none was needed
 */
public record GoalReport(
    Optional<String> id,
    GoalState state,
    boolean confirmed,
    Map<String, Term> binding,
    List<String> reasons,
    int calls,
    int replans,
    Duration duration,
    double decisionMillis) {
  public GoalReport {
    binding = Collections.unmodifiableMap(new TreeMap<>(binding));
    reasons = List.copyOf(reasons);
  }

  /**
   * The words in which the end of a goal is told.
   *
   * @param goal as it was stated
   */
  public static Content words(Formula goal, GoalOutcome outcome) {
    Formula bound = new Substitution(outcome.binding()).apply(goal);
    return Words.content(
        "inform",
        Words.named("goal", Words.name(outcome.id()), Words.formula(bound)),
        Words.terms("binding", outcome.binding()),
        Words.named("state", Words.name(outcome.state().name().toLowerCase(Locale.ROOT))),
        Words.named("confirmed", Words.name(String.valueOf(outcome.confirmed()))),
        Words.named("reasons", outcome.reasons().stream().map(Words::text).toList()),
        Words.named("calls", Words.number(outcome.calls())),
        Words.named("replans", Words.number(outcome.replans())),
        Words.named("seconds", Words.number(outcome.duration().toMillis() / 1000.0)),
        Words.named("decision-ms", Words.number(outcome.decisionMillis())));
  }

  /** A goal that was never taken up. */
  public static GoalReport refused(String reason) {
    return new GoalReport(
        Optional.empty(),
        GoalState.FAILED,
        false,
        Map.of(),
        List.of(reason),
        0,
        0,
        Duration.ZERO,
        0);
  }

  public boolean reached() {
    return state == GoalState.ACHIEVED;
  }

  /** The id that a goal has got, from the answer that takes it on. */
  public static String acceptedId(String content) {
    return parsed(content).string("goal").orElse("");
  }

  /** Reads what {@link #words} wrote, or why the goal was not taken on. */
  public static GoalReport read(String content) {
    Words words = parsed(content);
    Optional<String> state = words.string("state");
    if (state.isEmpty()) {
      return refused(words.string("reason").orElse(content));
    }
    return new GoalReport(
        words.string("goal"),
        GoalState.valueOf(state.get().toUpperCase(Locale.ROOT)),
        words.string("confirmed").filter("true"::equals).isPresent(),
        words.termsOf("binding"),
        words.strings("reasons"),
        (int) words.number("calls", 0),
        (int) words.number("replans", 0),
        Duration.ofMillis((long) (words.number("seconds", 0) * 1000)),
        words.number("decision-ms", 0));
  }

  private static Words parsed(String content) {
    return Words.of(Words.parse(content).get(0));
  }
}
