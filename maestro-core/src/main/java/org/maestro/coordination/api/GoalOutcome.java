package org.maestro.coordination.api;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import org.maestro.sl.Term;

/**
 * The end of a goal: in which state, for which reasons, and after which effort.
 *
 * @param confirmed a witness has seen it; false when only its doer says so, or nobody can look
 *     again
 * @param binding values of the goal's free variables
 * @param reasons why it failed, in sentences; empty when reached
 * @param calls feature calls started
 * @param replans plans made after the first, without the one that confirms
 * @param decisionMillis wall time from the goal's arrival to its first call; 0 when none was needed
 * @param searches what was looked at in vain and what could not be looked at, when it failed and
 *     nobody knows where a thing is that it names
 */
public record GoalOutcome(
    String id,
    String goal,
    GoalState state,
    boolean confirmed,
    Map<String, Term> binding,
    List<String> reasons,
    int calls,
    int replans,
    Duration submittedAt,
    Duration endedAt,
    double decisionMillis,
    List<SearchReport> searches) {
  private static final long BYTES = 512;
  private static final long BYTES_OF_A_SEARCH = 2_048;

  public GoalOutcome {
    searches = List.copyOf(searches);
  }

  /** An outcome without searches to tell of. */
  public GoalOutcome(
      String id,
      String goal,
      GoalState state,
      boolean confirmed,
      Map<String, Term> binding,
      List<String> reasons,
      int calls,
      int replans,
      Duration submittedAt,
      Duration endedAt,
      double decisionMillis) {
    this(
        id,
        goal,
        state,
        confirmed,
        binding,
        reasons,
        calls,
        replans,
        submittedAt,
        endedAt,
        decisionMillis,
        List.of());
  }

  /** What it takes of memory, about. */
  public long bytes() {
    long characters = goal.length();
    for (String reason : reasons) {
      characters += reason.length();
    }
    return BYTES + BYTES_OF_A_SEARCH * searches.size() + 2 * characters;
  }

  public boolean reached() {
    return state == GoalState.ACHIEVED;
  }

  /** Simulated time from arrival to end. */
  public Duration duration() {
    return endedAt.minus(submittedAt);
  }
}
